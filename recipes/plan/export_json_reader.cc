// The reader of what export_json.cc writes. Strict: every member is known, of its type and within
// bounds, and everything that is required is there.
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "recipes/plan/export.h"
#include "recipes/plan/export_fragment.h"

namespace lares::recipes {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxItems = 10'000;         // of one array or object
constexpr std::size_t kMaxText_bytes = 1u << 16;  // of one text
constexpr int kMaxDepth = 64;                     // of findings below findings
constexpr std::int64_t kMaxWhole = 1'000'000'000;
constexpr double kMaxSeconds = 1e9;

// A value and where it stands: "/states/0/inputs/2/value".
struct Node {
  const json& value;
  std::string pointer;

  [[noreturn]] void Fail(const std::string& what) const {
    throw Error(Code::kInvalid, (pointer.empty() ? "/" : pointer) + " " + what);
  }
  Node At(const std::string& name) const {
    std::string escaped;
    for (const char c : name) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return {value.at(name), pointer + "/" + escaped};
  }
};

// The members of an object: those asked for are the known ones.
class Members {
 public:
  explicit Members(const Node& node) : node_(node) {
    if (!node.value.is_object()) node.Fail("must be an object");
    if (node.value.size() > kMaxItems) node.Fail("has too many members");
  }

  Node Required(const char* name) {
    if (!Has(name)) node_.Fail("lacks \"" + std::string(name) + "\"");
    return node_.At(name);
  }
  std::optional<Node> Optional(const char* name) {
    return Has(name) ? std::optional<Node>(node_.At(name)) : std::nullopt;
  }
  void RefuseOthers() const {
    for (const auto& item : node_.value.items()) {
      if (known_.count(item.key()) == 0) node_.At(item.key()).Fail("is not known here");
    }
  }

 private:
  bool Has(const char* name) {
    known_.insert(name);
    return node_.value.contains(name);
  }
  Node node_;
  std::set<std::string> known_;
};

std::string Text(const Node& node) {
  if (!node.value.is_string()) node.Fail("must be a text");
  const auto& text = node.value.get_ref<const std::string&>();
  if (text.size() > kMaxText_bytes) node.Fail("is too long");
  return text;
}

std::string FilledText(const Node& node) {
  std::string text = Text(node);
  if (text.empty()) node.Fail("must not be empty");
  return text;
}

bool Boolean(const Node& node) {
  if (!node.value.is_boolean()) node.Fail("must be true or false");
  return node.value.get<bool>();
}

int Whole(const Node& node, std::int64_t most) {
  if (!node.value.is_number_integer()) node.Fail("must be a whole number");
  const bool large = node.value.is_number_unsigned() &&
                     node.value.get<std::uint64_t>() > static_cast<std::uint64_t>(most);
  const std::int64_t number = large ? most + 1 : node.value.get<std::int64_t>();
  if (number < 0 || number > most) node.Fail("must be from 0 to " + std::to_string(most));
  return static_cast<int>(number);
}

double Seconds(const Node& node) {
  if (!node.value.is_number()) node.Fail("must be a number");
  const double seconds = node.value.get<double>();
  if (!(seconds > 0) || seconds > kMaxSeconds) node.Fail("must be above 0 and at most 1e9");
  return seconds;
}

template <typename Read>
auto Array(const Node& node, const Read& read) {
  if (!node.value.is_array()) node.Fail("must be an array");
  if (node.value.size() > kMaxItems) node.Fail("has too many items");
  std::vector<decltype(read(node))> items;
  items.reserve(node.value.size());
  for (std::size_t i = 0; i < node.value.size(); ++i) {
    items.push_back(read(Node{node.value[i], node.pointer + "/" + std::to_string(i)}));
  }
  return items;
}

std::vector<std::string> Texts(const Node& node) { return Array(node, Text); }

// The value whose name it is; `name` gives the names.
template <typename Value, std::size_t n>
Value OneOf(const Node& node, const std::array<Value, n>& values, std::string_view (*name)(Value)) {
  const std::string text = Text(node);
  std::string known;
  for (const Value value : values) {
    if (name(value) == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  node.Fail("must be one of " + known);
}

Resource ReadResource(const Node& node) {
  Members members(node);
  Resource resource{Text(members.Required("iri")), Text(members.Required("label")),
                    Text(members.Required("as_written"))};
  members.RefuseOthers();
  return resource;
}

std::vector<Resource> ReadResources(const Node& node) { return Array(node, ReadResource); }

Parameter ReadParameter(const Node& node) {
  Members members(node);
  Parameter parameter;
  parameter.name = FilledText(members.Required("name"));
  parameter.type = FilledText(members.Required("type"));
  parameter.value = FilledText(members.Required("value"));
  parameter.text = Text(members.Required("text"));
  static constexpr std::array kSources = {Parameter::Source::kRecipe, Parameter::Source::kRobot,
                                          Parameter::Source::kEnvironment,
                                          Parameter::Source::kTemplate, Parameter::Source::kStep};
  parameter.source = OneOf(members.Required("source"), kSources, ToString);
  const Node origin = members.Required("origin");
  if (!origin.value.is_null()) parameter.origin = ReadResource(origin);
  if (const auto unit = members.Optional("unit")) parameter.unit = FilledText(*unit);
  if (const auto frame = members.Optional("frame")) parameter.frame = FilledText(*frame);
  members.RefuseOthers();
  return parameter;
}

Fluent ReadFluent(const Node& node) {
  Members members(node);
  Fluent fluent;
  fluent.name = FilledText(members.Required("name"));
  fluent.holds = Boolean(members.Required("holds"));
  if (const auto argument = members.Optional("argument")) fluent.argument = FilledText(*argument);
  members.RefuseOthers();
  return fluent;
}

Effect ReadEffect(const Node& node) {
  Members members(node);
  Effect effect{FilledText(members.Required("outcome")), ReadFluent(members.Required("fluent"))};
  members.RefuseOthers();
  return effect;
}

std::string ReadFragment(const Node& node) {
  std::string fragment = FilledText(node);
  const auto problems = TreeFragmentProblems(fragment);
  if (!problems.empty()) node.Fail("cannot be used: " + problems.front());
  return fragment;
}

void ReadSkill(Members& members, State& state) {
  state.step = ReadResource(members.Required("step"));
  state.action = ReadResource(members.Required("action"));
  state.skill = FilledText(members.Required("skill"));
  state.skill_template = Text(members.Required("skill_template"));
  state.rada_distance = Whole(members.Required("rada_distance"), kMaxWhole);
  state.inputs = Array(members.Required("inputs"), ReadParameter);
  const Node outputs = members.Required("outputs");
  if (!outputs.value.is_object()) outputs.Fail("must be an object");
  if (outputs.value.size() > kMaxItems) outputs.Fail("has too many members");
  for (const auto& item : outputs.value.items()) {
    state.outputs.emplace(item.key(), FilledText(outputs.At(item.key())));
  }
  if (const auto parallel = members.Optional("parallel")) state.parallel = FilledText(*parallel);
  if (const auto retries = members.Optional("retries")) state.retries = Whole(*retries, 1000);
  if (const auto limit = members.Optional("time_limit_s")) state.time_limit_s = Seconds(*limit);
  if (const auto own = members.Optional("tree_fragment")) state.tree_fragment = ReadFragment(*own);
  if (const auto claims = members.Optional("claims")) state.claims = ReadResources(*claims);
  if (const auto needs = members.Optional("preconditions")) {
    state.preconditions = Array(*needs, ReadFluent);
  }
  if (const auto effects = members.Optional("effects")) {
    state.effects = Array(*effects, ReadEffect);
  }
}

State ReadState(const Node& node) {
  Members members(node);
  State state;
  state.id = FilledText(members.Required("id"));
  state.label = Text(members.Required("label"));
  const Node kind = members.Required("kind");
  const std::string kind_name = Text(kind);
  if (kind_name == "end") {
    state.kind = State::Kind::kEnd;
    state.success = Boolean(members.Required("success"));
  } else if (kind_name == "parallel") {
    state.kind = State::Kind::kParallel;
    state.members = Texts(members.Required("members"));
    state.outcomes = Texts(members.Required("outcomes"));
  } else if (kind_name == "skill") {
    ReadSkill(members, state);
    state.outcomes = Texts(members.Required("outcomes"));
  } else {
    kind.Fail("must be one of skill, parallel, end");
  }
  members.RefuseOthers();
  return state;
}

Transition ReadTransition(const Node& node) {
  Members members(node);
  Transition transition;
  transition.from = FilledText(members.Required("from"));
  transition.outcome = FilledText(members.Required("outcome"));
  transition.to = FilledText(members.Required("to"));
  transition.added = Boolean(members.Required("added"));
  if (const auto reason = members.Optional("reason")) transition.reason = Text(*reason);
  members.RefuseOthers();
  return transition;
}

Setting ReadSetting(const Node& node) {
  Members members(node);
  Setting setting;
  setting.name = FilledText(members.Required("name"));
  setting.type = FilledText(members.Required("type"));
  setting.value = Text(members.Required("value"));
  setting.text = Text(members.Required("text"));
  setting.is_default = Boolean(members.Required("is_default"));
  if (const auto unit = members.Optional("unit")) setting.unit = FilledText(*unit);
  if (const auto was = members.Optional("was")) setting.was = FilledText(*was);
  members.RefuseOthers();
  return setting;
}

Finding ReadFinding(const Node& node, int depth) {
  if (depth > kMaxDepth) node.Fail("lies too deep");
  Members members(node);
  Finding finding;
  const Node kind = members.Required("kind");
  const std::string kind_name = Text(kind);
  if (kind_name != "capability" && kind_name != "component") {
    kind.Fail("must be one of capability, component");
  }
  finding.kind = kind_name == "capability" ? Finding::Kind::kCapability : Finding::Kind::kComponent;
  finding.what = ReadResource(members.Required("what"));
  static constexpr std::array kAvailabilities = {Availability::kAvailable,
                                                 Availability::kOnMakersWord,
                                                 Availability::kDerivable, Availability::kMissing};
  finding.availability = OneOf(members.Required("availability"), kAvailabilities, ToString);
  finding.asserted = Boolean(members.Required("asserted"));
  finding.provided_by = ReadResources(members.Required("provided_by"));
  finding.dependencies = Array(members.Required("dependencies"),
                               [&](const Node& each) { return ReadFinding(each, depth + 1); });
  finding.explanation = Text(members.Required("explanation"));
  members.RefuseOthers();
  return finding;
}

Need ReadNeed(const Node& node) {
  Members members(node);
  Need need{ReadResource(members.Required("step")), ReadResource(members.Required("capability")),
            ReadResources(members.Required("inherited_through"))};
  members.RefuseOthers();
  return need;
}

MatchReport ReadMatch(const Node& node) {
  Members members(node);
  MatchReport match;
  match.task = ReadResource(members.Required("task"));
  match.robot = ReadResource(members.Required("robot"));
  match.feasible = Boolean(members.Required("feasible"));
  match.needs = Array(members.Required("needs"), ReadNeed);
  match.capabilities = Array(members.Required("capabilities"),
                             [](const Node& each) { return ReadFinding(each, 1); });
  match.smallest_repair = ReadResources(members.Required("smallest_repair"));
  match.warnings = Texts(members.Required("warnings"));
  members.RefuseOthers();
  return match;
}

void ReadEnvironment(const Node& node, Plan& plan) {
  if (node.value.is_null()) return;
  Members members(node);
  plan.environment = FilledText(members.Required("id"));
  plan.environment_version = Whole(members.Required("version"), kMaxWhole);
  members.RefuseOthers();
}

}  // namespace

Plan PlanFromJson(const json& value) {
  const Node node{value, ""};
  Members members(node);
  const Node format = members.Required("format");
  if (Text(format) != "lares-plan") format.Fail("must be \"lares-plan\"");
  const Node version = members.Required("format_version");
  if (Whole(version, kMaxWhole) != 1) version.Fail("must be 1; no other is known here");
  Plan plan;
  plan.task = ReadResource(members.Required("task"));
  plan.robot = ReadResource(members.Required("robot"));
  ReadEnvironment(members.Required("environment"), plan);
  plan.start = FilledText(members.Required("start"));
  plan.states = Array(members.Required("states"), ReadState);
  plan.transitions = Array(members.Required("transitions"), ReadTransition);
  plan.unordered = Array(members.Required("unordered"), Texts);
  plan.notes = Texts(members.Required("notes"));
  plan.match = ReadMatch(members.Required("match"));
  if (const auto settings = members.Optional("settings")) {
    plan.settings = Array(*settings, ReadSetting);
  }
  if (const auto assumptions = members.Optional("assumptions")) {
    plan.assumptions = Array(*assumptions, ReadFluent);
  }
  if (const auto done = members.Optional("done")) plan.done = Texts(*done);
  if (const auto given = members.Optional("given")) plan.given = Texts(*given);
  members.RefuseOthers();
  return plan;
}

}  // namespace lares::recipes
