// Views for tests: a catalogue of our own modules and what a test puts above it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/plan/plan.h"

namespace lares::testing {

// One for the process: Prolog starts once.
prolog::EnginePool& Engines();

// A stack of closed layers. `name` of a layer is its graph's.
class World {
 public:
  // Our ontology modules and skill templates; `more` are further modules of the catalogue.
  explicit World(const std::vector<std::filesystem::path>& more = {});

  World& Put(const std::string& name, std::string_view turtle);
  World& PutFile(const std::string& name, const std::filesystem::path& path, bool recover = false);

  const rdf::View& view() const { return view_; }

 private:
  rdf::Graph Read(const std::string& name, std::string_view bytes, const std::string& file_name,
                  bool recover);
  void Close(std::vector<rdf::Graph> graphs);

  rdf::AliasTable aliases_;
  rdf::View view_;
};

// The catalogue of our own modules, closed once for the process.
const World& Catalogue();

std::filesystem::path Source(const std::string& relative);

// The prefixes that test documents use: lares, owl, rdf, rdfs, xsd, and ':' for
// https://example.org/test#.
std::string Turtle(std::string_view body);
std::string Example(std::string_view local);  // https://example.org/test#local
std::string Lares(std::string_view local);    // https://w3id.org/lares#local

// A recipe in Turtle. `steps`: name and the classes or restrictions above it.
struct StepText {
  std::string name;
  std::string above;  // Turtle objects of rdfs:subClassOf: "lares:Reaching , [ … ]"
};
struct MoveText {
  std::string from, cause, to;
};
// ":Task" as a state machine; `start` and `ends` are step names.
std::string StateMachine(const std::vector<StepText>& steps, const std::string& start,
                         const std::vector<std::string>& ends, const std::vector<MoveText>& moves);
// ":Task" as a partial order; each pair is "before, after".
std::string PartialOrder(const std::vector<StepText>& steps,
                         const std::vector<std::pair<std::string, std::string>>& orders);
// ":robot" with parts of these classes and these claimed capabilities (both lares: names).
std::string RobotText(const std::vector<std::string>& parts,
                      const std::vector<std::string>& capabilities);
// "[ … someValuesFrom … ]" / hasValue.
std::string Some(const std::string& property, const std::string& filler);
std::string Has(const std::string& property, const std::string& value);

std::vector<std::string> Labels(const std::vector<recipes::Resource>& resources);

}  // namespace lares::testing
