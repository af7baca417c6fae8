#include "tests/recipes/world.h"

#include <algorithm>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"

namespace lares::testing {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> TurtleFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".ttl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string Subclass(const std::string& name, const std::string& above) {
  return ":" + name + " a owl:Class ; rdfs:subClassOf " + above + " .\n";
}

}  // namespace

prolog::EnginePool& Engines() {
  static auto* engines = new prolog::EnginePool();  // lives as long as the process
  return *engines;
}

World::World(const std::vector<fs::path>& more)
    : aliases_(rdf::AliasTable::FromTsv(ReadFile(Source("ontology/aliases.tsv")), "aliases.tsv")),
      view_(std::make_shared<rdf::Dictionary>()) {
  std::vector<fs::path> files = TurtleFiles(Source("ontology"));
  for (const fs::path& file : TurtleFiles(Source("recipes/skills"))) files.push_back(file);
  files.insert(files.end(), more.begin(), more.end());
  std::vector<rdf::Graph> graphs;
  for (const fs::path& file : files) {
    graphs.push_back(Read(file.filename().string(), ReadFile(file), file.string(), false));
  }
  Close(std::move(graphs));
}

World& World::Put(const std::string& name, std::string_view turtle) {
  Close({Read(name, turtle, name + ".ttl", false)});
  return *this;
}

World& World::PutFile(const std::string& name, const fs::path& path, bool recover) {
  Close({Read(name, ReadFile(path), path.string(), recover)});
  return *this;
}

rdf::Graph World::Read(const std::string& name, std::string_view bytes,
                       const std::string& file_name, bool recover) {
  rdf::ReadOptions options;
  options.source = file_name;
  options.recover = recover;
  options.base_iri = "https://example.org/" + name;
  const rdf::Document document =
      rdf::ReadRdf(bytes, rdf::GuessFormat("", file_name, bytes), options);
  return rdf::MakeGraph(document, name, aliases_, view_.dictionary());
}

void World::Close(std::vector<rdf::Graph> graphs) {
  view_ = view_.With(owl::Materialise(view_, std::move(graphs)));
}

const World& Catalogue() {
  static const auto* world = new World();
  return *world;
}

fs::path Source(const std::string& relative) { return fs::path(LARES_SOURCE_DIR) / relative; }

std::string Turtle(std::string_view body) {
  return "@prefix : <https://example.org/test#> .\n"
         "@prefix lares: <https://w3id.org/lares#> .\n"
         "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
         "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
         "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
         "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n" +
         std::string(body);
}

std::string Example(std::string_view local) {
  return "https://example.org/test#" + std::string(local);
}
std::string Lares(std::string_view local) { return "https://w3id.org/lares#" + std::string(local); }

std::string Some(const std::string& property, const std::string& filler) {
  return "[ a owl:Restriction ; owl:onProperty " + property + " ; owl:someValuesFrom " + filler +
         " ]";
}
std::string Has(const std::string& property, const std::string& value) {
  return "[ a owl:Restriction ; owl:onProperty " + property + " ; owl:hasValue " + value + " ]";
}

std::string StateMachine(const std::vector<StepText>& steps, const std::string& start,
                         const std::vector<std::string>& ends, const std::vector<MoveText>& moves) {
  std::string above = "lares:PurposefulAction";
  std::string rest;
  for (const StepText& step : steps) {
    above += " , " + Some("lares:subAction", ":" + step.name);
    rest += Subclass(step.name, step.above);
  }
  if (!start.empty()) above += " , " + Has("lares:taskStartState", ":" + start);
  for (const std::string& end : ends) above += " , " + Has("lares:taskEndState", ":" + end);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::string id = ":move" + std::to_string(i);
    above += " , " + Has("lares:stateTransition", id);
    rest += id + " a lares:IntrinsicStateChangeEvent";
    if (!moves[i].from.empty()) rest += " ; lares:fromState :" + moves[i].from;
    if (!moves[i].cause.empty()) rest += " ; lares:causedBy lares:" + moves[i].cause;
    if (!moves[i].to.empty()) rest += " ; lares:toState :" + moves[i].to;
    rest += " .\n";
  }
  return Turtle(Subclass("Task", above) + rest);
}

std::string PartialOrder(const std::vector<StepText>& steps,
                         const std::vector<std::pair<std::string, std::string>>& orders) {
  std::string above = "lares:PurposefulAction";
  std::string rest;
  for (const StepText& step : steps) {
    above += " , " + Some("lares:subAction", ":" + step.name);
    rest += Subclass(step.name, step.above);
  }
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const std::string id = ":order" + std::to_string(i);
    above += " , " + Has("lares:orderingConstraints", id);
    rest += id + " lares:occursBeforeInOrdering :" + orders[i].first +
            " ; lares:occursAfterInOrdering :" + orders[i].second + " .\n";
  }
  return Turtle(Subclass("Task", above) + rest);
}

std::string RobotText(const std::vector<std::string>& parts,
                      const std::vector<std::string>& capabilities) {
  std::string above = "lares:Robot";
  for (const std::string& capability : capabilities) {
    above += " , " + Some("lares:hasCapability", "lares:" + capability);
  }
  std::string rest = ":robot a :Kind";
  std::string part_texts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string part = ":part" + std::to_string(i);
    rest += " ; lares:subComponent " + part;
    part_texts += part + " a lares:" + parts[i] + " .\n";
  }
  return Turtle(Subclass("Kind", above) + rest + " .\n" + part_texts);
}

std::vector<std::string> Labels(const std::vector<recipes::Resource>& resources) {
  std::vector<std::string> labels;
  for (const recipes::Resource& resource : resources) labels.push_back(resource.label);
  return labels;
}

}  // namespace lares::testing
