// The reader of what export_json.cc writes. Strict: every member is known, of its type and within
// bounds, and everything that is required is there.
#include "recipes/plan/export.h"
#include "recipes/plan/export_fragment.h"
#include "recipes/plan/export_json_node.h"
#include "recipes/plan/export_match_reader.h"

namespace lares::recipes {
namespace {

constexpr int kMostRetries = static_cast<int>(kMaxRetries);

int ReadInt(const JsonNode& node, std::int64_t most) {
  return static_cast<int>(ReadWhole(node, most));
}

double ReadSeconds(const JsonNode& node) {
  const double seconds = ReadNumber(node);
  if (seconds > 0 && seconds <= kMaxTimeLimit_s) return seconds;
  node.Fail("must be above 0 and at most " + std::to_string(static_cast<int>(kMaxTimeLimit_s)));
}

Parameter ReadParameter(const JsonNode& node) {
  JsonMembers members(node);
  Parameter parameter;
  parameter.name = ReadFilledText(members.Required("name"));
  parameter.type = ReadFilledText(members.Required("type"));
  parameter.value = ReadFilledText(members.Required("value"));
  parameter.text = ReadText(members.Required("text"));
  static constexpr std::array kSources = {
      Parameter::Source::kRecipe,   Parameter::Source::kRobot, Parameter::Source::kEnvironment,
      Parameter::Source::kTemplate, Parameter::Source::kStep,  Parameter::Source::kRequest};
  parameter.source = ReadOneOf(members.Required("source"), kSources, ToString);
  const JsonNode origin = members.Required("origin");
  if (!origin.IsNull()) parameter.origin = ReadResource(origin);
  if (const auto unit = members.Optional("unit")) parameter.unit = ReadFilledText(*unit);
  if (const auto frame = members.Optional("frame")) parameter.frame = ReadFilledText(*frame);
  members.RefuseOthers();
  return parameter;
}

Fluent ReadFluent(const JsonNode& node) {
  JsonMembers members(node);
  Fluent fluent;
  fluent.name = ReadFilledText(members.Required("name"));
  fluent.holds = ReadBoolean(members.Required("holds"));
  if (const auto argument = members.Optional("argument"))
    fluent.argument = ReadFilledText(*argument);
  members.RefuseOthers();
  return fluent;
}

Effect ReadEffect(const JsonNode& node) {
  JsonMembers members(node);
  Effect effect{ReadFilledText(members.Required("outcome")),
                ReadFluent(members.Required("fluent"))};
  members.RefuseOthers();
  return effect;
}

std::string ReadFragment(const JsonNode& node) {
  std::string fragment = ReadFilledText(node);
  const auto problems = TreeFragmentProblems(fragment);
  if (!problems.empty()) node.Fail("cannot be used: " + problems.front());
  return fragment;
}

void ReadSkill(JsonMembers& members, State& state) {
  state.step = ReadResource(members.Required("step"));
  state.action = ReadResource(members.Required("action"));
  state.skill = ReadFilledText(members.Required("skill"));
  state.skill_template = ReadText(members.Required("skill_template"));
  state.rada_distance = ReadInt(members.Required("rada_distance"), kMaxWhole);
  state.inputs = ReadArray(members.Required("inputs"), ReadParameter);
  const JsonNode outputs = members.Required("outputs");
  for (const std::string& name : JsonNames(outputs)) {
    state.outputs.emplace(name, ReadFilledText(outputs.At(name)));
  }
  if (const auto parallel = members.Optional("parallel"))
    state.parallel = ReadFilledText(*parallel);
  if (const auto retries = members.Optional("retries"))
    state.retries = ReadInt(*retries, kMostRetries);
  if (const auto limit = members.Optional("time_limit_s")) state.time_limit_s = ReadSeconds(*limit);
  if (const auto own = members.Optional("tree_fragment")) state.tree_fragment = ReadFragment(*own);
  if (const auto claims = members.Optional("claims")) state.claims = ReadResources(*claims);
  if (const auto needs = members.Optional("preconditions")) {
    state.preconditions = ReadArray(*needs, ReadFluent);
  }
  if (const auto effects = members.Optional("effects")) {
    state.effects = ReadArray(*effects, ReadEffect);
  }
}

State ReadState(const JsonNode& node) {
  JsonMembers members(node);
  State state;
  state.id = ReadFilledText(members.Required("id"));
  state.label = ReadText(members.Required("label"));
  const JsonNode kind = members.Required("kind");
  const std::string kind_name = ReadText(kind);
  if (kind_name == "end") {
    state.kind = State::Kind::kEnd;
    state.success = ReadBoolean(members.Required("success"));
  } else if (kind_name == "parallel") {
    state.kind = State::Kind::kParallel;
    state.members = ReadTexts(members.Required("members"));
    state.outcomes = ReadTexts(members.Required("outcomes"));
  } else if (kind_name == "skill") {
    ReadSkill(members, state);
    state.outcomes = ReadTexts(members.Required("outcomes"));
  } else {
    kind.Fail("must be one of skill, parallel, end");
  }
  members.RefuseOthers();
  return state;
}

Transition ReadTransition(const JsonNode& node) {
  JsonMembers members(node);
  Transition transition;
  transition.from = ReadFilledText(members.Required("from"));
  transition.outcome = ReadFilledText(members.Required("outcome"));
  transition.to = ReadFilledText(members.Required("to"));
  transition.added = ReadBoolean(members.Required("added"));
  if (const auto reason = members.Optional("reason")) transition.reason = ReadText(*reason);
  members.RefuseOthers();
  return transition;
}

Setting ReadSetting(const JsonNode& node) {
  JsonMembers members(node);
  Setting setting;
  setting.name = ReadFilledText(members.Required("name"));
  setting.type = ReadFilledText(members.Required("type"));
  setting.value = ReadText(members.Required("value"));
  setting.text = ReadText(members.Required("text"));
  setting.is_default = ReadBoolean(members.Required("is_default"));
  if (const auto unit = members.Optional("unit")) setting.unit = ReadFilledText(*unit);
  if (const auto was = members.Optional("was")) setting.was = ReadFilledText(*was);
  members.RefuseOthers();
  return setting;
}

void ReadEnvironment(const JsonNode& node, Plan& plan) {
  if (node.IsNull()) return;
  JsonMembers members(node);
  plan.environment = ReadFilledText(members.Required("id"));
  plan.environment_version = ReadInt(members.Required("version"), kMaxWhole);
  members.RefuseOthers();
}

}  // namespace

Plan PlanFromJson(const nlohmann::json& value) {
  const JsonNode node{value, ""};
  JsonMembers members(node);
  const JsonNode format = members.Required("format");
  if (ReadText(format) != "lares-plan") format.Fail("must be \"lares-plan\"");
  const JsonNode version = members.Required("format_version");
  if (ReadInt(version, kMaxWhole) != 1) version.Fail("must be 1; no other is known here");
  Plan plan;
  plan.task = ReadResource(members.Required("task"));
  plan.robot = ReadResource(members.Required("robot"));
  ReadEnvironment(members.Required("environment"), plan);
  plan.start = ReadFilledText(members.Required("start"));
  plan.states = ReadArray(members.Required("states"), ReadState);
  plan.transitions = ReadArray(members.Required("transitions"), ReadTransition);
  plan.unordered = ReadArray(members.Required("unordered"), ReadTexts);
  plan.notes = ReadTexts(members.Required("notes"));
  plan.match = ReadMatch(members.Required("match"));
  if (const auto settings = members.Optional("settings")) {
    plan.settings = ReadArray(*settings, ReadSetting);
  }
  if (const auto assumptions = members.Optional("assumptions")) {
    plan.assumptions = ReadArray(*assumptions, ReadFluent);
  }
  if (const auto done = members.Optional("done")) plan.done = ReadTexts(*done);
  if (const auto given = members.Optional("given")) plan.given = ReadTexts(*given);
  members.Optional("package");  // what can be downloaded is the server's, not the plan's
  members.RefuseOthers();
  return plan;
}

}  // namespace lares::recipes
