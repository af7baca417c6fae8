#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

struct PlanOptions {
  std::string task;
  std::string robot;
  std::string environment;
  int version = 0;
  bool strict = false;
  std::string as = "text";
  std::vector<std::string> templates;
  std::string out;
};

Json RequestBody(const PlanOptions& plan) {
  Json body{{"task", plan.task}, {"robot", plan.robot}};
  if (!plan.environment.empty()) body["environment"] = plan.environment;
  if (plan.version > 0) body["version"] = plan.version;
  if (plan.strict) body["strict"] = true;
  for (const std::string& choice : plan.templates) {
    const std::size_t equals = choice.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == choice.size()) {
      throw CLI::ValidationError("--template", "write it as STEP=TEMPLATE");
    }
    body["templates"][choice.substr(0, equals)] = choice.substr(equals + 1);
  }
  return body;
}

// The server's explanation for people, once more as it stands in the problem document.
void PrintRefusal(const RemoteError& error) {
  const Json document = Json::parse(error.document(), nullptr, false);
  std::string text = TextOf(document, "text");
  if (!text.empty() && text.back() != '\n') text += '\n';
  if (document.contains("capable_robots") && !document["capable_robots"].empty()) {
    text += "robots that can:";
    for (const Json& robot : document["capable_robots"]) text += " " + TextOf(robot, "label");
    text += "\n";
  }
  Print(text);
}

void MakePlan(const PlanOptions& plan, const Options& options) {
  Remote remote(options.server);
  http::ClientRequest request;
  request.method = "POST";
  request.path = "/v1/plans";
  request.query.emplace("as", options.json ? "json" : plan.as);
  request.headers.Set("Content-Type", "application/json");
  request.body = RequestBody(plan).dump();
  http::ClientResponse response;
  try {
    response = remote.Send(request);
  } catch (const RemoteError& error) {
    if (ExitCodeOf(error.problem_code()) == ExitCode::kNoPlan && !options.json) PrintRefusal(error);
    throw;
  }
  if (plan.out.empty()) return Print(response.body);
  WriteFileAtomically(plan.out, response.body);
  Print("wrote " + plan.out + "\n");
}

}  // namespace

void AddPlan(CLI::App& app, const Options& options) {
  auto* command = AddCommand(
      app, "plan", "A plan of a task for one robot, or why there is none",
      "  lares plan FindBottle --robot pioneer\n"
      "  lares plan FindBottle --robot pioneer --environment hospital-room --as bt-xml --out "
      "plan.xml\n"
      "  lares plan FindBottle --robot PR2 --as dot | dot -Tsvg > plan.svg");
  auto plan = std::make_shared<PlanOptions>();
  command->add_option("TASK", plan->task, "recipe's id, or the task's IRI, label or local name")
      ->required();
  command->add_option("--robot", plan->robot, "id, IRI or label")->required();
  command->add_option("--environment", plan->environment, "where it is to be done");
  command->add_option("--version", plan->version, "of the environment (default: the newest)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--strict", plan->strict, "do not take a capability on the robot maker's word");
  command
      ->add_option("--as", plan->as,
                   "text, json, bt-xml (BehaviorTree.CPP 4), dot, pddl-domain or pddl-problem")
      ->check(CLI::IsMember({"text", "json", "bt-xml", "dot", "pddl-domain", "pddl-problem"}))
      ->capture_default_str();
  command->add_option("--template", plan->templates,
                      "STEP=TEMPLATE: which skill a step shall use; may be repeated");
  command->add_option("--out", plan->out, "file to write instead of standard output");
  command->callback([=, &options] { MakePlan(*plan, options); });
}

}  // namespace lares::cli
