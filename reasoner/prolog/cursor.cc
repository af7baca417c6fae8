#include "reasoner/prolog/cursor.h"

#include <algorithm>
#include <utility>

namespace lares::prolog {
namespace {

// An index run is preferred to a scan of the graph when it is this many times shorter.
constexpr std::size_t kLookupCost = 16;

bool Fits(rdf::TermId wanted, rdf::TermId found) {
  return wanted == rdf::kAnyTerm || wanted == found;
}

// The run of a subject in sorted triples.
std::span<const rdf::Triple> SubjectRun(const std::vector<rdf::Triple>& triples,
                                        rdf::TermId subject) {
  const auto low = std::partition_point(
      triples.begin(), triples.end(), [&](const auto& triple) { return triple.subject < subject; });
  const auto high = std::partition_point(
      low, triples.end(), [&](const auto& triple) { return triple.subject == subject; });
  return {low, high};
}

}  // namespace

Cursor::Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern,
               rdf::Origin origin)
    : pattern_(pattern), all_(std::in_place, std::move(view), pattern, origin) {}

Cursor::Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern,
               const rdf::Graph& graph)
    : pattern_(pattern), graph_(&graph) {
  if (pattern.subject != rdf::kAnyTerm) {
    run_ = SubjectRun(graph.triples, pattern.subject);
    view_ = std::move(view);
  } else if (view->Estimate(pattern) > graph.triples.size() / kLookupCost) {
    run_ = graph.triples;
    view_ = std::move(view);
  } else {
    all_.emplace(std::move(view), pattern, rdf::Origin::kAll);
  }
}

bool Cursor::Accepts(const rdf::Triple& triple) const {
  if (!all_) {
    return Fits(pattern_.subject, triple.subject) && Fits(pattern_.predicate, triple.predicate) &&
           Fits(pattern_.object, triple.object);
  }
  return graph_ == nullptr ||
         std::binary_search(graph_->triples.begin(), graph_->triples.end(), triple);
}

bool Cursor::Candidate(rdf::Triple* triple) {
  if (all_) return all_->Next(triple);
  if (run_.empty()) return false;
  *triple = run_.front();
  run_ = run_.subspan(1);
  return true;
}

// Finds the next triple that is accepted.
void Cursor::Prefetch() {
  rdf::Triple triple;
  while (!next_ && !ended_) {
    if (!Candidate(&triple)) {
      ended_ = true;
    } else if (Accepts(triple)) {
      next_ = triple;
    }
  }
}

bool Cursor::Next(rdf::Triple* triple) {
  if (Done()) return false;
  *triple = *next_;
  next_.reset();
  return true;
}

bool Cursor::Done() {
  Prefetch();
  return !next_.has_value();
}

const rdf::Graph* FindGraph(const rdf::View& view, std::string_view name) {
  for (const auto& layer : view.layers()) {
    for (const rdf::Graph& graph : layer->graphs()) {
      if (graph.name == name) return &graph;
    }
  }
  return nullptr;
}

}  // namespace lares::prolog
