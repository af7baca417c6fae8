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

Asserted Arrange(const std::vector<rdf::Graph>& graphs, const rdf::View& below,
                 const Engine& engine) {
  Asserted asserted;
  for (const rdf::Graph& graph : graphs) {
    for (const rdf::Triple& triple : graph.triples) {
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
    if (facts.OriginOf(i) != 0) inferred.push_back(facts.At(i));
  }
  return inferred;
}

}  // namespace

std::shared_ptr<const rdf::Layer> Materialise(const rdf::View& below,
                                              std::vector<rdf::Graph> graphs,
                                              const Options& options, std::stop_token stop) {
  Engine engine(below, options, std::move(stop));
  Asserted asserted = Arrange(graphs, below, engine);
  engine.Run(asserted.list_cells);
  engine.SettleLists();
  engine.Run(asserted.schema);
  engine.Run(asserted.data);
  rdf::Inference inference;
  inference.inferred = Inferred(engine);
  inference.clashes = engine.TakeClashes();
  inference.clash_count = engine.clash_count();
  inference.held_below = std::move(asserted.held_below);
  return std::make_shared<const rdf::Layer>(std::move(graphs), std::move(inference));
}

}  // namespace lares::owl
