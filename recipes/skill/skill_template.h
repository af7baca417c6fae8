// Skill templates: what a robot's own programming can carry out, as documents say it.
#pragma once

#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/resource.h"

namespace lares::recipes {

struct SkillInput {
  std::string name;
  std::string type;
  std::string unit;  // SI symbol, empty when it has none
  bool optional = false;
  std::vector<std::string> sources;  // for people, in the order to try: "recipe: to location"
};

struct SkillOutput {
  std::string name;
  std::string type;
  Resource key_property;
};

struct SkillOutcome {
  std::string name;
  Resource means;  // empty when it has no result
  std::vector<std::string> effects;
};

struct SkillTemplate {
  Resource iri;
  std::string comment;
  std::vector<Resource> actions;        // what it serves; one, unless something is wrong
  std::string skill;                    // what the robot runs
  std::vector<std::string> conditions;  // for people: "for robots with holonomic base"
  std::vector<SkillInput> inputs;
  std::vector<SkillOutput> outputs;
  std::vector<SkillOutcome> outcomes;
  std::string retries;       // as written; empty for none
  std::string time_limit_s;  // likewise
  std::string tree_fragment;
  std::vector<Resource> claims;
  std::vector<std::string> preconditions;
  std::vector<std::string> problems;  // each makes it unusable: refused at put
  std::vector<std::string> warnings;
};

// The templates of `graph`, or of all documents of `view` when it is empty; by IRI.
std::vector<SkillTemplate> FindTemplates(prolog::EnginePool& engines, const rdf::View& view,
                                         const std::string& graph = "");

}  // namespace lares::recipes
