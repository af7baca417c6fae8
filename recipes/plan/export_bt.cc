// BehaviorTree.CPP v4. A state graph has no direct counterpart in a behaviour tree; a variable
// `state` and a loop over "if this is the state, run its skill and set the next state" have the
// same traces. Plans that are a plain row become a plain Sequence.
#include <sstream>

#include "base/text.h"
#include "recipes/plan/export.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

constexpr std::string_view kContract =
    "Every skill node writes the name of its outcome to the port \"outcome\" and returns FAILURE "
    "when that is \"failed\", SUCCESS otherwise. Poses are written \"x y z qx qy qz qw\" in "
    "metres.";

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) escaped += c;  // XML 1.0 has no others
    }
  }
  return escaped;
}

std::string Attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + Escaped(value) + "\"";
}

// The tree itself uses two keys.
std::string SafeKey(const std::string& key) {
  return key == "state" || key == "outcome" ? key + "_value" : key;
}

std::string InputValue(const Parameter& parameter) {
  if (parameter.source != Parameter::Source::kStep) return parameter.value;
  return "{" + SafeKey(KeyOf(parameter.value)) + "}";
}

std::string SkillNode(const State& state, bool with_outcome) {
  std::string node = "<" + state.skill + Attribute("name", state.id);
  for (const Parameter& input : state.inputs) node += Attribute(input.name, InputValue(input));
  for (const auto& [output, key] : state.outputs) {
    node += Attribute(output, "{" + SafeKey(key) + "}");
  }
  if (with_outcome) node += Attribute("outcome", "{outcome}");
  return node + "/>";
}

// "state := (outcome == 'true') ? 'a' : ((outcome == 'false') ? 'b' : 'c')". Grouped by brackets:
// the language's ternary does not associate.
std::string NextState(const State& state, const std::map<std::string, std::string>& ways) {
  std::vector<std::pair<std::string, std::string>> cases;
  for (const std::string& outcome : state.outcomes) {
    const auto way = ways.find(outcome);
    if (way != ways.end()) cases.emplace_back(outcome, way->second);
  }
  if (cases.empty()) return "state := ''";
  std::string expression = "'" + cases.back().second + "'";
  for (std::size_t i = cases.size() - 1; i-- > 0;) {
    const bool last = i + 2 == cases.size();
    expression = "(outcome == '" + cases[i].first + "') ? '" + cases[i].second +
                 "' : " + (last ? expression : "(" + expression + ")");
  }
  return "state := " + expression;
}

void WriteStateBranch(std::ostream& out, const State& state,
                      const std::map<std::string, std::string>& ways) {
  const std::string indent(12, ' ');
  out << indent << "<Sequence" << Attribute("name", state.id) << ">\n"
      << indent << "  <ScriptCondition" << Attribute("code", "state == '" + state.id + "'")
      << "/>\n"
      << indent << "  <Script" << Attribute("code", "outcome := 'failed'") << "/>\n"
      << indent << "  <ForceSuccess>" << SkillNode(state, true) << "</ForceSuccess>\n"
      << indent << "  <Script" << Attribute("code", NextState(state, ways)) << "/>\n"
      << indent << "</Sequence>\n";
}

void WriteSequence(std::ostream& out, const std::vector<const State*>& steps) {
  out << "    <Sequence>\n";
  for (const State* step : steps) out << "      " << SkillNode(*step, true) << "\n";
  out << "    </Sequence>\n";
}

// True at each successful end of the plan.
std::string SuccessCondition(const Plan& plan) {
  std::string condition;
  for (const State& state : plan.states) {
    if (state.kind != State::Kind::kEnd || !state.success) continue;
    condition += (condition.empty() ? "state == '" : " || state == '") + state.id + "'";
  }
  return condition.empty() ? "false" : condition;
}

void WriteStateLoop(std::ostream& out, const Plan& plan) {
  const Ways ways = WaysOf(plan);
  out << "    <Sequence>\n"
      << "      <Script" << Attribute("code", "state := '" + plan.start + "'") << "/>\n"
      << "      <ForceSuccess>\n        <KeepRunningUntilFailure>\n          <Fallback>\n";
  for (const State& state : plan.states) {
    if (state.kind == State::Kind::kEnd) continue;
    const auto own = ways.find(state.id);
    static const std::map<std::string, std::string> kNone;
    WriteStateBranch(out, state, own == ways.end() ? kNone : own->second);
  }
  out << "          </Fallback>\n        </KeepRunningUntilFailure>\n      </ForceSuccess>\n"
      << "      <ScriptCondition" << Attribute("code", SuccessCondition(plan)) << "/>\n"
      << "    </Sequence>\n";
}

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
    if (state.kind == State::Kind::kEnd) continue;
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
  out << "      <" << element << Attribute("name", name) << Attribute("type", port.type) << ">"
      << Escaped(port.description) << "</" << element << ">\n";
}

void WriteModels(std::ostream& out, const Plan& plan) {
  out << "  <TreeNodesModel>\n";
  for (const auto& [skill, model] : SkillModels(plan)) {
    out << "    <Action" << Attribute("ID", skill) << ">\n";
    for (const auto& [name, port] : model.inputs) WritePort(out, "input_port", name, port);
    for (const auto& [name, port] : model.outputs) WritePort(out, "output_port", name, port);
    WritePort(out, "output_port", "outcome", {"std::string", "how the skill ended"});
    out << "    </Action>\n";
  }
  out << "  </TreeNodesModel>\n";
}

std::string TreeId(const Plan& plan) {
  std::string id;
  for (const char c : LocalName(plan.task.iri)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    id += plain ? c : '_';
  }
  return id.empty() ? "Plan" : id;
}

}  // namespace

std::string ToBehaviorTreeXml(const Plan& plan) {
  std::ostringstream out;
  const std::string id = TreeId(plan);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " << kContract << " -->\n"
      << "<root BTCPP_format=\"4\"" << Attribute("main_tree_to_execute", id) << ">\n"
      << "  <BehaviorTree" << Attribute("ID", id) << ">\n";
  const std::vector<const State*> steps = LinearSteps(plan);
  if (steps.empty()) {
    WriteStateLoop(out, plan);
  } else {
    WriteSequence(out, steps);
  }
  out << "  </BehaviorTree>\n";
  WriteModels(out, plan);
  out << "</root>\n";
  return out.str();
}

}  // namespace lares::recipes
