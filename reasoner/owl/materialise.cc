#include "reasoner/owl/materialise.h"

#include <utility>

#include "ontology/triples/sorting.h"
#include "reasoner/owl/engine.h"

namespace lares::owl {
namespace {

// What the graphs assert, in the order in which it is best run.
struct Asserted {
  std::vector<rdf::Triple> list_cells, schema, data, held_below;
};

Asserted Arrange(const std::vector<rdf::Graph>& graphs, const rdf::View& below, Engine& engine) {
  Asserted asserted;
  std::size_t count = 0;
  for (const rdf::Graph& graph : graphs) count += graph.triples.size();
  asserted.data.reserve(count);
  for (const rdf::Graph& graph : graphs) {
    for (const rdf::Triple& triple : graph.triples) {
      engine.NoteLiteral(triple.object);
      if (below.Contains(triple)) {
        asserted.held_below.push_back(triple);
      } else if (engine.IsListCell(triple)) {
        asserted.list_cells.push_back(triple);
      } else {
        (engine.IsSchema(triple) ? asserted.schema : asserted.data).push_back(triple);
      }
    }
  }
  rdf::SortAndDeduplicate(asserted.held_below);
  return asserted;
}

std::vector<rdf::Triple> Inferred(const Engine& engine) {
  std::vector<rdf::Triple> inferred;
  const Facts& facts = engine.facts();
  for (std::size_t i = 0; i < facts.size(); ++i) {
    // By representatives, what is asserted may be another triple.
    const bool is_known = facts.OriginOf(i) == 0 && engine.equality().empty();
    if (!is_known && engine.IsForLayer(i)) inferred.push_back(facts.At(i));
  }
  return inferred;
}

}  // namespace

std::shared_ptr<const rdf::Layer> Materialise(const rdf::View& below,
                                              std::vector<rdf::Graph> graphs,
                                              const Options& options, std::stop_token stop) {
  Engine engine(below, options, std::move(stop));
  Asserted asserted = Arrange(graphs, below, engine);
  const std::size_t count =
      asserted.list_cells.size() + asserted.schema.size() + asserted.data.size();
  engine.Reserve(count + count / 2);
  engine.Run(asserted.list_cells);
  engine.SettleLists();
  engine.Run(asserted.schema);
  engine.Run(asserted.data);
  rdf::Inference inference;
  inference.inferred = Inferred(engine);
  inference.clash_count = engine.clash_count();
  inference.clashes = engine.TakeClashes();
  inference.held_below = std::move(asserted.held_below);
  inference.equality = engine.has_new_equality()
                           ? std::make_shared<const rdf::Equality>(engine.equality())
                           : below.shared_equality();
  return std::make_shared<const rdf::Layer>(
      std::move(graphs), std::move(inference),
      engine.has_literal_subjects() ? &below.dictionary() : nullptr);
}

}  // namespace lares::owl
