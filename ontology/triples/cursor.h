// Answers one at a time, for callers that cannot give a callback.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::rdf {

// Pins its view until it is destroyed. One thread at a time.
class Cursor {
 public:
  Cursor(std::shared_ptr<const View> view, const Pattern& pattern, Origin origin = Origin::kAll);
  Cursor(Cursor&&) = default;
  Cursor& operator=(Cursor&&) = default;

  // The next answer into `*triple`; false, leaving it alone, when there are no more.
  bool Next(Triple* triple);

 private:
  bool IsAnswer(const Triple& triple) const;

  std::shared_ptr<const View> view_;
  Pattern pattern_;
  Origin origin_;
  std::size_t next_layer_ = 0;
  std::span<const Triple> rest_;   // of the layer before next_layer_, or of collected_
  std::vector<Triple> collected_;  // all answers, where the view has terms that are the same
};

}  // namespace lares::rdf
