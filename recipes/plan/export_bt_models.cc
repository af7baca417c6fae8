#include "recipes/plan/export_bt_models.h"

#include <map>
#include <ostream>

#include "recipes/plan/export_xml.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

struct Port {
  std::string type;
  std::string description;
};

struct SkillModel {
  std::map<std::string, Port> inputs;
  std::map<std::string, Port> outputs;
};

std::string PortType(const std::string& type) {
  if (type == "number") return "double";
  if (type == "boolean") return "bool";
  return "std::string";
}

std::map<std::string, SkillModel> SkillModels(const Plan& plan) {
  std::map<std::string, SkillModel> models;
  for (const State& state : plan.states) {
    if (state.kind != State::Kind::kSkill) continue;
    SkillModel& model = models[state.skill];
    for (const Parameter& input : state.inputs) {
      std::string description = input.type;
      if (!input.unit.empty()) description += " in " + input.unit;
      model.inputs.emplace(input.name, Port{PortType(input.type), description});
    }
    for (const auto& [output, key] : state.outputs) {
      model.outputs.emplace(output, Port{"std::string", "what the skill creates"});
    }
  }
  return models;
}

void WritePort(std::ostream& out, std::string_view element, const std::string& name,
               const Port& port) {
  out << "      <" << element << XmlAttribute("name", name) << XmlAttribute("type", port.type)
      << ">" << EscapedXml(port.description, XmlUse::kText) << "</" << element << ">\n";
}

}  // namespace

void WriteSkillModels(std::ostream& out, const Plan& plan) {
  out << "  <TreeNodesModel>\n";
  for (const auto& [skill, model] : SkillModels(plan)) {
    out << "    <Action" << XmlAttribute("ID", skill) << ">\n";
    for (const auto& [name, port] : model.inputs) WritePort(out, "input_port", name, port);
    for (const auto& [name, port] : model.outputs) WritePort(out, "output_port", name, port);
    WritePort(out, "output_port", "outcome", {"std::string", "how the skill ended"});
    out << "    </Action>\n";
  }
  out << "  </TreeNodesModel>\n";
}

}  // namespace lares::recipes
