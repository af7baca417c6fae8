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
    : view_(std::move(view)), pattern_(pattern), origin_(origin) {
  if (view_->equality() != nullptr) Collect();
}

Cursor::Cursor(std::shared_ptr<const rdf::View> view, const rdf::Pattern& pattern,
               const rdf::Graph& graph)
    : view_(std::move(view)), pattern_(pattern), graph_(&graph) {
  if (pattern.subject != rdf::kAnyTerm) {
    run_ = SubjectRun(graph.triples, pattern.subject);
    scans_graph_ = true;
  } else if (view_->Estimate(pattern) > graph.triples.size() / kLookupCost) {
    run_ = graph.triples;
    scans_graph_ = true;
  } else if (view_->equality() != nullptr) {
    Collect();
  }
}

void Cursor::Collect() {
  collected_ = view_->Match(pattern_);
  run_ = collected_;
  next_layer_ = view_->layers().size();
}

bool Cursor::Accepts(const rdf::Triple& triple) const {
  if (scans_graph_) {
    return Fits(pattern_.subject, triple.subject) && Fits(pattern_.predicate, triple.predicate) &&
           Fits(pattern_.object, triple.object);
  }
  if (graph_ != nullptr) {
    return std::binary_search(graph_->triples.begin(), graph_->triples.end(), triple);
  }
  if (origin_ == rdf::Origin::kAsserted) return view_->IsAsserted(triple);
  return !view_->has_literal_subjects() ||
         view_->dictionary().Kind(triple.subject) != rdf::TermKind::kLiteral;
}

// Moves run_ to the next triple that is accepted; empty when there is none.
void Cursor::Prefetch() {
  if (prefetched_) return;
  prefetched_ = true;
  while (true) {
    while (!run_.empty()) {
      if (Accepts(run_.front())) return;
      run_ = run_.subspan(1);
    }
    if (scans_graph_ || next_layer_ == view_->layers().size()) return;
    run_ = view_->layers()[next_layer_++]->Range(pattern_);
  }
}

bool Cursor::Next(rdf::Triple* triple) {
  if (Done()) return false;
  *triple = run_.front();
  run_ = run_.subspan(1);
  prefetched_ = false;
  return true;
}

bool Cursor::Done() {
  Prefetch();
  return run_.empty();
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
