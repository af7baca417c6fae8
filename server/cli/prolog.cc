#include <unistd.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/print.h"
#include "server/cli/prolog_text.h"

namespace lares::cli {
namespace {

struct PrologOptions {
  std::string goal;
  std::string recipe, robot, environment;
  int version = 0;
  int limit = 1000;
  double timeout_s = 10;
};

struct StopAsking {};  // the person has seen enough

// Lines of a stream that comes in pieces.
class Lines {
 public:
  explicit Lines(std::function<void(const std::string&)> take) : take_(std::move(take)) {}

  void Add(std::string_view piece) {
    rest_ += piece;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = rest_.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      take_(rest_.substr(begin, end - begin));
    }
    rest_.erase(0, begin);
  }

 private:
  std::function<void(const std::string&)> take_;
  std::string rest_;
};

std::string RequestBody(const PrologOptions& prolog, const std::string& goal) {
  Json body{{"goal", goal}, {"limit", prolog.limit}, {"timeout_s", prolog.timeout_s}};
  if (!prolog.recipe.empty()) body["recipe"] = prolog.recipe;
  if (!prolog.robot.empty()) body["robot"] = prolog.robot;
  if (!prolog.environment.empty()) body["environment"] = prolog.environment;
  if (prolog.version > 0) body["version"] = prolog.version;
  return body.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// What the last line of a stream says.
void PrintEnd(const Json& end) {
  if (TextOf(end, "outcome") == "no") Print("no\n");
  if (end.contains("error")) {
    throw Error(Code::kInvalid, "after the last answer: " + TextOf(end["error"], "detail"));
  }
  if (end.contains("complete") && end["complete"] == false) {
    Print("there may be more answers (--limit)\n");
  }
}

// Asks once; `ask_on` says after each answer whether to go on.
void Ask(const PrologOptions& prolog, const Options& options, const std::string& goal,
         const std::function<bool()>& ask_on) {
  Remote remote(options.server);
  http::ClientRequest request{"POST", "/v1/prolog", {}, {}, RequestBody(prolog, goal)};
  request.headers.Set("Content-Type", "application/json");
  request.headers.Set("Accept", "application/x-ndjson");
  Json end = Json::object();
  Lines lines([&](const std::string& line) {
    if (options.json) return Print(line + "\n");
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("outcome")) {
      end = json;
    } else if (json.is_object() && json.contains("answer") && json["answer"].is_object()) {
      Print(AnswerText(json["answer"]));
      const bool go_on = ask_on();
      if (!go_on) throw StopAsking();
    } else {
      throw Error(Code::kIo, "what answers at " + remote.url() + " is no Lares server");
    }
  });
  try {
    remote.Send(request, {[&](std::string_view piece) { lines.Add(piece); }, {}, {}});
  } catch (const StopAsking&) {
    return;
  }
  if (!options.json) PrintEnd(end);
}

// Goals from standard input, each up to a line that ends with a full stop.
class Conversation {
 public:
  Conversation(const PrologOptions& prolog, const Options& options)
      : prolog_(prolog), options_(options), is_person_(::isatty(STDIN_FILENO) != 0) {}

  void Run() {
    if (is_person_) Print("Goals end with a full stop; ; for the next answer; Ctrl-D to leave.\n");
    while (true) {
      const std::string goal = ReadGoal();
      if (goal.empty()) return;
      AnswerOne(goal);
    }
  }

 private:
  std::string ReadGoal() {
    std::string goal, line;
    while (true) {
      if (is_person_) Print(goal.empty() ? "?- " : "|  ");
      if (!std::getline(std::cin, line)) break;
      if (goal.empty() && Trim(line).empty()) continue;
      goal += line + "\n";
      if (std::string_view(Trim(line)).ends_with('.')) break;
    }
    return goal;
  }

  // A person goes on after an error; a script ends.
  void AnswerOne(const std::string& goal) {
    try {
      Ask(prolog_, options_, goal, [this] { return WantsMore(); });
    } catch (const Error& error) {
      if (!is_person_) throw;
      Print(std::string(error.FullMessage()) + "\n");
    }
  }

  bool WantsMore() const {
    if (!is_person_) {
      Print("\n");
      return true;
    }
    Print("  ");
    std::string line;
    return std::getline(std::cin, line) && Trim(line) == ";";
  }

  const PrologOptions& prolog_;
  const Options& options_;
  const bool is_person_;
};

}  // namespace

void AddProlog(CLI::App& app, const Options& options) {
  auto* command =
      AddCommand(app, "prolog", "Ask a Prolog goal, or one after the other from standard input",
                 "  lares prolog \"subclass(lares:'Cup', X)\"\n"
                 "  lares prolog \"rdf(X, rdf:type, lares:'Cup')\" --environment kitchen\n"
                 "  lares prolog < goals.pl");
  auto prolog = std::make_shared<PrologOptions>();
  command->add_option("GOAL", prolog->goal, "without it: goals from standard input");
  command->add_option("--recipe", prolog->recipe, "to be known beside the catalogue");
  command->add_option("--robot", prolog->robot, "likewise");
  command->add_option("--environment", prolog->environment, "likewise");
  command->add_option("--version", prolog->version, "of the environment (default: the newest)")
      ->check(CLI::PositiveNumber);
  command->add_option("--limit", prolog->limit, "answers at most")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--timeout", prolog->timeout_s, "seconds that the goal may think")
      ->check(CLI::Range(0.001, 60.0))
      ->capture_default_str();
  command->callback([=, &options] {
    if (prolog->goal.empty()) return Conversation(*prolog, options).Run();
    Ask(*prolog, options, prolog->goal, [] {
      Print("\n");
      return true;
    });
  });
}

}  // namespace lares::cli
