// A pattern's answers one by one, pinning the view they come from.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::prolog {

// Not thread-safe. The view lives at least as long as its cursors.
class Cursor {
 public:
  Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern, rdf::Origin origin);
  // Only what `graph`, one of the view's, asserts.
  Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern,
         const rdf::Graph& graph);
  Cursor(Cursor&&) = default;
  Cursor& operator=(Cursor&&) = default;

  const rdf::Pattern& pattern() const { return pattern_; }
  // False when there are no more.
  bool Next(rdf::Triple* triple);
  // True when Next() would find nothing.
  bool Done();

 private:
  void Collect();
  bool Accepts(const rdf::Triple& triple) const;
  void Prefetch();

  std::shared_ptr<const rdf::View> view_;
  rdf::Pattern pattern_;
  rdf::Origin origin_ = rdf::Origin::kAll;
  const rdf::Graph* graph_ = nullptr;
  bool scans_graph_ = false;  // run_ is a part of graph_->triples, else of a layer
  std::size_t next_layer_ = 0;
  std::span<const rdf::Triple> run_;
  std::vector<rdf::Triple> collected_;  // what run_ is of, where terms of the view are the same
  bool prefetched_ = false;
};

// The graph of that name; null when the view has none.
const rdf::Graph* FindGraph(const rdf::View& view, std::string_view name);

}  // namespace lares::prolog
