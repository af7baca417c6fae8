// A pattern's answers one by one, pinning the view they come from.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "ontology/triples/cursor.h"

namespace lares::prolog {

// Not thread-safe. The view lives at least as long as its cursors.
class Cursor {
 public:
  Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern, rdf::Origin origin);
  // Only what `graph`, one of the view's, asserts.
  Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern,
         const rdf::Graph& graph);

  const rdf::Pattern& pattern() const { return pattern_; }
  // False when there are no more.
  bool Next(rdf::Triple* triple);
  // True when Next() would find nothing.
  bool Done();

 private:
  bool Accepts(const rdf::Triple& triple) const;
  bool Candidate(rdf::Triple* triple);
  void Prefetch();

  std::shared_ptr<const rdf::View> view_;  // pinned by all_ where that is there
  rdf::Pattern pattern_;
  const rdf::Graph* graph_ = nullptr;
  std::optional<rdf::Cursor> all_;    // of the view; nothing when run_ is scanned
  std::span<const rdf::Triple> run_;  // of graph_->triples
  std::optional<rdf::Triple> next_;   // found already
  bool ended_ = false;
};

// The graph of that name; null when the view has none.
const rdf::Graph* FindGraph(const rdf::View& view, std::string_view name);

}  // namespace lares::prolog
