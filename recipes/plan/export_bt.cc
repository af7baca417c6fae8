// BehaviorTree.CPP v4. A state graph has no direct counterpart in a behaviour tree; a variable
// `state` and a loop over "if this is the state, run its skill and set the next state" have the
// same traces. Plans that are a plain row become a plain Sequence.
//
// The nodes used have memory: Sequence and Fallback go on at the child that was running, so a skill
// that takes many ticks is started once and the conditions before it are not asked again.
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "base/text.h"
#include "recipes/plan/export.h"
#include "recipes/plan/export_bt_models.h"
#include "recipes/plan/export_fragment.h"
#include "recipes/plan/export_xml.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

constexpr std::string_view kContract =
    "Every skill node writes the name of its outcome to the port \"outcome\" and returns FAILURE "
    "when that is \"failed\", SUCCESS otherwise; one that takes time returns RUNNING meanwhile and "
    "stops when it is halted. Poses are written \"x y z qx qy qz qw\" in metres.";

// Where the tree itself keeps what it needs to know.
constexpr std::string_view kOutcome = "outcome";
constexpr std::string_view kMemberOutcome = "outcome_of_";  // and the member's number

// Other keys must not be the tree's own, nor what one of those becomes here.
std::string SafeKey(const std::string& key) {
  constexpr std::string_view kSuffix = "_value";
  std::string_view bare = key;
  while (bare.ends_with(kSuffix)) bare.remove_suffix(kSuffix.size());
  const bool taken = bare == "state" || bare == kOutcome || bare.starts_with(kMemberOutcome);
  return taken ? key + std::string(kSuffix) : key;
}

std::string InputValue(const Parameter& parameter) {
  if (parameter.source != Parameter::Source::kStep) return parameter.value;
  return "{" + SafeKey(KeyOf(parameter.value)) + "}";
}

std::string SkillNode(const State& state, std::string_view outcome_key) {
  std::string node = "<" + state.skill + XmlAttribute("name", state.id);
  for (const Parameter& input : state.inputs) node += XmlAttribute(input.name, InputValue(input));
  for (const auto& [output, key] : state.outputs) {
    node += XmlAttribute(output, "{" + SafeKey(key) + "}");
  }
  return node + XmlAttribute("outcome", "{" + std::string(outcome_key) + "}") + "/>";
}

// The retries around the time limit: the limit is that of one attempt.
std::vector<TreeDecorator> Decorators(const State& state) {
  if (!state.tree_fragment.empty()) {
    TreeFragment fragment = ParseTreeFragment(state.tree_fragment);
    if (fragment.problems.empty()) return std::move(fragment.decorators);
    throw Error(Code::kInvalid, "the behaviour tree of '" + state.id +
                                    "' cannot be used: " + Join(fragment.problems, "; "));
  }
  std::vector<TreeDecorator> decorators;
  if (state.retries > 0) {
    decorators.push_back({"RetryUntilSuccessful", "num_attempts", state.retries + 1LL});
  }
  if (state.time_limit_s > 0) {
    const long long limit_ms = std::max(1LL, std::llround(state.time_limit_s * 1000));
    decorators.push_back({"Timeout", "msec", limit_ms});
  }
  return decorators;
}

// The skill in its decorators, each on a line of its own.
void WriteSkill(std::ostream& out, const State& state, std::string_view outcome_key,
                std::string indent) {
  const std::vector<TreeDecorator> decorators = Decorators(state);
  for (const TreeDecorator& decorator : decorators) {
    out << indent << "<" << decorator.name
        << XmlAttribute(decorator.attribute, std::to_string(decorator.number)) << ">\n";
    indent += "  ";
  }
  out << indent << SkillNode(state, outcome_key) << "\n";
  for (auto decorator = decorators.rbegin(); decorator != decorators.rend(); ++decorator) {
    indent.resize(indent.size() - 2);
    out << indent << "</" << decorator->name << ">\n";
  }
}

// Side by side: SUCCESS when every member has succeeded; FAILURE as soon as one has failed, and the
// others are halted. Each member has an outcome of its own; only its status counts here.
void WriteParallel(std::ostream& out, const Plan& plan, const State& state,
                   const std::string& indent) {
  out << indent << "<Parallel" << XmlAttribute("name", state.id)
      << " success_count=\"-1\" failure_count=\"1\">\n";
  int number = 0;
  for (const std::string& id : state.members) {
    const State* member = FindState(plan, id);
    if (member == nullptr) {
      throw Error(Code::kInvalid, "'" + state.id + "' runs '" + id + "', which is no state");
    }
    WriteSkill(out, *member, std::string(kMemberOutcome) + std::to_string(++number), indent + "  ");
  }
  out << indent << "</Parallel>\n";
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

std::string Script(std::string_view code) { return "<Script" + XmlAttribute("code", code) + "/>"; }

// What happened is in `outcome` afterwards, whatever the skill has written on the way: a FAILURE,
// be it of the last attempt or of its time limit, is always "failed", and a skill that has written
// nothing is taken to have failed.
void WriteStateBranch(std::ostream& out, const Plan& plan, const State& state,
                      const std::map<std::string, std::string>& ways) {
  const std::string indent(12, ' ');
  const bool parallel = state.kind == State::Kind::kParallel;
  out << indent << "<Sequence" << XmlAttribute("name", state.id) << ">\n"
      << indent << "  <ScriptCondition" << XmlAttribute("code", "state == '" + state.id + "'")
      << "/>\n";
  if (!parallel) out << indent << "  " << Script("outcome := 'failed'") << "\n";
  out << indent << "  <Fallback>\n";
  if (parallel) {
    out << indent << "    <Sequence>\n";
    WriteParallel(out, plan, state, indent + "      ");
    out << indent << "      " << Script("outcome := 'succeeded'") << "\n"
        << indent << "    </Sequence>\n";
  } else {
    WriteSkill(out, state, kOutcome, indent + "    ");
  }
  out << indent << "    " << Script("outcome := 'failed'") << "\n"
      << indent << "  </Fallback>\n"
      << indent << "  " << Script(NextState(state, ways)) << "\n"
      << indent << "</Sequence>\n";
}

void WriteSequence(std::ostream& out, const Plan& plan, const std::vector<const State*>& steps) {
  const std::string indent(6, ' ');
  out << "    <Sequence>\n";
  for (const State* step : steps) {
    if (step->kind == State::Kind::kParallel) {
      WriteParallel(out, plan, *step, indent);
    } else {
      WriteSkill(out, *step, kOutcome, indent);
    }
  }
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
      << "      " << Script("state := '" + plan.start + "'") << "\n"
      << "      <ForceSuccess>\n        <KeepRunningUntilFailure>\n          <Fallback>\n";
  for (const State& state : plan.states) {
    if (state.kind == State::Kind::kEnd || !state.parallel.empty()) continue;
    const auto own = ways.find(state.id);
    static const std::map<std::string, std::string> kNone;
    WriteStateBranch(out, plan, state, own == ways.end() ? kNone : own->second);
  }
  out << "          </Fallback>\n        </KeepRunningUntilFailure>\n      </ForceSuccess>\n"
      << "      <ScriptCondition" << XmlAttribute("code", SuccessCondition(plan)) << "/>\n"
      << "    </Sequence>\n";
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
      << "<root BTCPP_format=\"4\"" << XmlAttribute("main_tree_to_execute", id) << ">\n"
      << "  <BehaviorTree" << XmlAttribute("ID", id) << ">\n";
  const std::vector<const State*> steps = LinearSteps(plan);
  if (steps.empty()) {
    WriteStateLoop(out, plan);
  } else {
    WriteSequence(out, plan, steps);
  }
  out << "  </BehaviorTree>\n";
  WriteSkillModels(out, plan);
  out << "</root>\n";
  return out.str();
}

}  // namespace lares::recipes
