#include "tests/reasoner/sparql/sparql_support.h"

namespace lares::sparql::testing {
namespace {

constexpr std::string_view kBase = "http://example.org/";

rdf::View ViewOf(std::string_view turtle, const std::shared_ptr<rdf::Dictionary>& dictionary) {
  rdf::ReadOptions options;
  options.base_iri = kBase;
  const std::string text = "@prefix : <http://example.org/> .\n" + std::string(turtle);
  std::vector<rdf::Graph> graphs;
  graphs.push_back(
      rdf::MakeGraph(rdf::ReadRdf(text, rdf::Format::kTurtle, options), "test", {}, *dictionary));
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(std::move(graphs), std::vector<rdf::Triple>(),
                                               std::vector<rdf::Clash>()));
}

std::string Short(const rdf::Term& term) {
  if (term.kind == rdf::TermKind::kIri && term.value.starts_with(kBase)) {
    return ":" + term.value.substr(kBase.size());
  }
  for (const std::string_view type : {"#integer", "#decimal", "#double", "#boolean"}) {
    if (term.datatype.ends_with(type)) return term.value;
  }
  return rdf::ToNTriples(term.view());
}

}  // namespace

World::World(std::string_view turtle) : view(ViewOf(turtle, dictionary)) {}

std::vector<std::string> Rows(const World& world, std::string_view query, const Limits& limits) {
  ParseOptions options;
  options.base_iri = kBase;
  options.prefixes = {{"", std::string(kBase)}, {"xsd", "http://www.w3.org/2001/XMLSchema#"}};
  const Answer answer = Evaluate(Parse(query, options), world.dataset(), limits);
  if (answer.form == Form::kAsk) return {answer.yes ? "yes" : "no"};
  std::vector<std::string> rows;
  for (const auto& cells : answer.rows) {
    std::string& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!cells[i]) continue;
      row += (row.empty() ? "" : " ") + answer.variables[i] + "=" + Short(*cells[i]);
    }
  }
  return rows;
}

}  // namespace lares::sparql::testing
