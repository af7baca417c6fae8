#include <nlohmann/json.hpp>

#include "base/error.h"
#include "recipes/plan/export.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/json_body.h"
#include "server/api/package.h"
#include "server/api/plans.h"
#include "server/api/recipe_robots.h"
#include "server/api/scope.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"

namespace lares::api {
namespace {

using PlainJson = nlohmann::json;

constexpr std::uint64_t kMaxPlanRequest = 1u << 20;

struct Format {
  const char* name;  // of ?as=
  const char* media_type;
};
constexpr Format kFormats[] = {{"json", "application/json"},   {"bt-xml", "application/xml"},
                               {"dot", "text/vnd.graphviz"},   {"text", "text/plain"},
                               {"pddl-domain", "text/x-pddl"}, {"pddl-problem", "text/x-pddl"}};

template <typename Value>
Value Member(const PlainJson& json, const char* name, Value otherwise, const char* type) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return otherwise;
  try {
    return found->get<Value>();
  } catch (const PlainJson::exception&) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be " + type);
  }
}

}  // namespace

server::PlanRequest ReadPlanRequest(const std::string& body) {
  const PlainJson json = ReadJsonObject(body, {"task", "robot", "environment", "version", "strict",
                                               "templates", "set", "sequential", "from", "done"});
  server::PlanRequest request;
  request.task = Member<std::string>(json, "task", "", "a text");
  request.robot = Member<std::string>(json, "robot", "", "a text");
  request.environment = Member<std::string>(json, "environment", "", "a text");
  if (json.contains("version") && !json["version"].is_number_integer()) {
    throw Error(Code::kInvalid, "'version' must be a whole number");
  }
  request.environment_version = Member<int>(json, "version", 0, "a whole number");
  request.strict = Member<bool>(json, "strict", false, "true or false");
  request.templates = Member<std::map<std::string, std::string>>(
      json, "templates", {}, "an object from steps to skill templates");
  request.set = Member<std::map<std::string, std::string>>(
      json, "set", {}, "an object from names to values, both texts");
  request.sequential = Member<bool>(json, "sequential", false, "true or false");
  request.from = Member<std::string>(json, "from", "", "a text");
  request.done = Member<std::vector<std::string>>(json, "done", {}, "an array of step ids");
  if (request.task.empty()) throw Error(Code::kInvalid, "'task' is missing");
  if (request.robot.empty()) throw Error(Code::kInvalid, "'robot' is missing");
  if (request.environment_version < 0)
    throw Error(Code::kInvalid, "'version' must not be negative");
  return request;
}

namespace {

const Format& ChooseFormat(const http::Request& request) {
  if (const auto as = request.Query("as")) {
    for (const Format& format : kFormats) {
      if (*as == format.name) return format;
    }
    throw Error(Code::kInvalid,
                "?as= is json, bt-xml, dot, text, pddl-domain or pddl-problem, not '" + *as + "'");
  }
  std::vector<std::string> offered;
  for (const Format& format : kFormats) offered.emplace_back(format.media_type);
  const auto chosen = http::ChooseMediaType(request.headers.GetList("Accept"), offered);
  for (const Format& format : kFormats) {
    if (chosen == format.media_type) return format;
  }
  throw http::ProblemError("not-acceptable",
                           "a plan is given as application/json, "
                           "application/xml, text/vnd.graphviz, text/plain or text/x-pddl");
}

std::string Write(const recipes::Plan& plan, const std::string& format) {
  if (format == "bt-xml") return recipes::ToBehaviorTreeXml(plan);
  if (format == "dot") return recipes::ToDot(plan);
  if (format == "text") return recipes::ToText(plan);
  if (format == "pddl-domain") return recipes::ToPddlDomain(plan);
  if (format == "pddl-problem") return recipes::ToPddlProblem(plan);
  return recipes::ToJson(plan).dump(2) + "\n";
}

std::string Labels(const std::vector<recipes::Resource>& resources) {
  std::string text;
  for (const recipes::Resource& resource : resources) {
    text += (text.empty() ? "" : ", ") + resource.label;
  }
  return text;
}

}  // namespace

http::ProblemError Refusal(const server::PlanAnswer& answer) {
  const recipes::PlanResult& result = answer.result;
  PlainJson members = recipes::ToJson(result);
  members["capable_robots"] = PlainJson(ToJson(answer.capable_robots));
  members["nearest_robots"] = PlainJson(ToJson(answer.nearest_robots));
  const recipes::MatchReport& match = result.match;
  const auto problem = [&](const char* code, const std::string& message) {
    members["text"] = code == std::string("not-feasible") ? recipes::ToText(match) : message;
    return http::ProblemError(code, message).WithMembers(members.dump());
  };
  if (!match.feasible) {
    members["smallest_repair"] = PlainJson(ToJson(match.smallest_repair));
    http::ProblemError error =
        problem("not-feasible", match.robot.label + " cannot do " + match.task.label +
                                    "; it lacks " + Labels(match.smallest_repair));
    if (!answer.capable_robots.empty()) {
      error.WithHint("robots that can: " + Labels(answer.capable_robots));
    }
    return error;
  }
  if (!result.problems.empty()) {
    std::string all;
    for (const std::string& sentence : result.problems) all += (all.empty() ? "" : "; ") + sentence;
    return problem("recipe-unusable", all);
  }
  std::string all;
  std::string step;
  for (const recipes::Choice& choice : result.choices) {
    all += (all.empty() ? "" : "; ") + choice.step.label + " could be done by " +
           Labels(choice.templates);
    step = choice.step.label;
  }
  http::ProblemError error = problem("choice-needed", all);
  error.WithHint("choose with \"templates\": {\"" + step + "\": …}, or --template " + step + "=…");
  return error;
}

namespace {

http::Response MakePlan(const http::Request& request, Context& context) {
  const Format& format = ChooseFormat(request);
  const server::PlanRequest asked = ReadPlanRequest(http::ReadWholeBody(request, kMaxPlanRequest));
  CheckReach(request, asked.environment);
  const server::PlanAnswer answer = context.knowledge.MakePlan(asked);
  if (!answer.result.plan) throw Refusal(answer);
  http::Response response;
  response.headers.Set("Content-Type", std::string(format.media_type) == "text/plain"
                                           ? "text/plain; charset=utf-8"
                                           : format.media_type);
  response.headers.Set("Vary", "Accept");
  if (format.name != std::string("json")) {
    response.body = Write(*answer.result.plan, format.name);
  } else {
    PlainJson plan = recipes::ToJson(*answer.result.plan);
    plan["package"] = ToJson(context.knowledge.MakePackage(asked, *answer.result.plan));
    response.body = plan.dump(2) + "\n";
  }
  return response;
}

}  // namespace

void AddPlanRoutes(http::Router& router, Context& context) {
  router.Add({"POST",
              "/v1/plans",
              "makePlan",
              [&context](const http::Request& request) { return MakePlan(request, context); },
              {"application/json"},
              kMaxPlanRequest});
}

}  // namespace lares::api
