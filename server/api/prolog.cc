#include <nlohmann/json.hpp>

#include "base/error.h"
#include "reasoner/prolog_worker/workers.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/json_body.h"
#include "server/api/scope.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"

namespace lares::api {
namespace {

constexpr std::uint64_t kMaxBody = 8u << 20;
constexpr std::size_t kMaxWholeBytes = 8u << 20;  // of answers in one JSON document
constexpr std::size_t kMaxStreamedBytes = 256u << 20;
constexpr double kMaxSeconds = 60;
constexpr int kMaxAnswers = 1'000'000;
constexpr std::chrono::milliseconds kPause{5};  // of a goal, before what it said is sent
constexpr const char* kLines = "application/x-ndjson";

// ---- The question ------------------------------------------------------------------------------

struct Question {
  server::ViewRequest view;
  prolog::GoalRequest goal;
};

template <typename Value>
Value Member(const Json& json, const char* name, Value otherwise, const char* type) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return otherwise;
  try {
    return found->get<Value>();
  } catch (const Json::exception&) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be " + type);
  }
}

int Whole(const Json& json, const char* name, int otherwise, int least, int most) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return otherwise;
  if (!found->is_number_integer() || *found < least || *found > most) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be a whole number from " +
                                    std::to_string(least) + " to " + std::to_string(most));
  }
  return found->get<int>();
}

Question ReadQuestion(const http::Request& request) {
  const Json json =
      ReadJsonObject(http::ReadWholeBody(request, kMaxBody),
                     {"goal", "recipe", "robot", "environment", "version", "limit", "timeout_s"});
  Question question;
  question.goal.goal = Member<std::string>(json, "goal", "", "a text");
  if (question.goal.goal.empty()) throw Error(Code::kInvalid, "'goal' is missing");
  question.view.recipe = Member<std::string>(json, "recipe", "", "a text");
  question.view.robot = Member<std::string>(json, "robot", "", "a text");
  question.view.environment = Member<std::string>(json, "environment", "", "a text");
  question.view.environment_version = Whole(json, "version", 0, 1, INT32_MAX);
  question.goal.max_answers = static_cast<std::size_t>(Whole(json, "limit", 1000, 1, kMaxAnswers));
  const double seconds = Member<double>(json, "timeout_s", 10, "a number of seconds");
  if (!(seconds > 0 && seconds <= kMaxSeconds)) {
    throw Error(Code::kInvalid, "'timeout_s' must be above 0 and at most 60");
  }
  question.goal.time = std::chrono::milliseconds(static_cast<long>(seconds * 1000) + 1);
  return question;
}

// ---- The answers -------------------------------------------------------------------------------

const char* OutcomeOf(const prolog::GoalEnd& end) {
  if (end.fault) return "error";
  return end.answers > 0 ? "yes" : "no";
}

Json FaultToJson(const prolog::GoalFault& fault) {
  Json json{{"kind", fault.kind}, {"detail", fault.message}};
  if (fault.line > 0) json["place"] = {{"line", fault.line}, {"column", fault.column}};
  return json;
}

Json EndToJson(const prolog::GoalEnd& end) {
  Json json{{"outcome", OutcomeOf(end)}, {"count", end.answers}, {"complete", end.complete}};
  if (end.fault) json["error"] = FaultToJson(*end.fault);
  return json;
}

// An error as a problem document. Time has the code that it has everywhere.
http::ProblemError ProblemOf(const prolog::GoalFault& fault) {
  const bool is_worker = fault.kind == "worker";
  const char* code = fault.kind == "time" ? "timeout" : is_worker ? "unavailable" : "goal-error";
  http::ProblemError error(code, fault.message);
  const Json members = FaultToJson(fault);
  Json added{{"kind", fault.kind}};
  if (members.contains("place")) added["place"] = members["place"];
  error.WithMembers(added.dump(-1, ' ', false, Json::error_handler_t::replace));
  return error;
}

using Goal = std::shared_ptr<prolog::RunningGoal>;

// {"outcome":…, "answers":[…], …} in memory.
http::Response WholeAnswer(const http::Request& request, prolog::RunningGoal& goal) {
  const std::stop_token gone = request.WatchClient();
  std::string answers;
  while (const auto answer = goal.Next(gone)) {
    answers += answers.empty() ? "\n" : ",\n";
    answers += *answer;
  }
  const prolog::GoalEnd& end = goal.end();
  if (end.fault && end.answers == 0) throw ProblemOf(*end.fault);
  http::Response response;
  response.headers.Set("Content-Type", "application/json");
  std::string head = EndToJson(end).dump(-1, ' ', false, Json::error_handler_t::replace);
  head.back() = ',';
  response.body = head + "\"answers\":[" + answers + "]}\n";
  return response;
}

// One line an answer, as it comes, and a last one that says how the goal ended.
void WriteLines(prolog::RunningGoal& goal, http::OpenSink& sink) {
  while (const auto answer = goal.Next(sink.gone())) {
    sink.Write("{\"answer\":" + *answer + "}\n");
    if (!goal.MoreWithin(kPause)) sink.Flush();
  }
  const prolog::GoalEnd& end = goal.end();
  if (end.fault && end.answers == 0) throw ProblemOf(*end.fault);
  sink.Write(EndToJson(end).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

http::Response Answer(const http::Request& request, Context& context) {
  const auto type =
      http::ChooseMediaType(request.headers.GetList("Accept"), {"application/json", kLines});
  if (!type) {
    throw http::ProblemError("not-acceptable",
                             "answers are given as application/json or application/x-ndjson");
  }
  Question question = ReadQuestion(request);
  CheckReach(request, question.view.environment);
  question.goal.max_bytes = type == kLines ? kMaxStreamedBytes : kMaxWholeBytes;
  const Goal goal = context.workers->Start(context.knowledge.ViewFor(question.view), question.goal);
  if (type != kLines) return WholeAnswer(request, *goal);
  http::Response response;
  response.headers.Set("Content-Type", kLines);
  response.body = http::OpenBody{[goal](http::OpenSink& sink) { WriteLines(*goal, sink); }};
  return response;
}

}  // namespace

void AddPrologRoutes(http::Router& router, Context& context) {
  router.Add({"POST",
              "/v1/prolog",
              "askProlog",
              [&context](const http::Request& request) { return Answer(request, context); },
              {"application/json"},
              kMaxBody});
}

}  // namespace lares::api
