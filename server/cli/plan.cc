#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/plan_package.h"
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
  std::vector<std::string> set;
  bool sequential = false;
  std::string from;
  std::vector<std::string> done;
  std::string out;
  std::string package;
};

// "--object Cup" for a recipe's parameter "object", as "--set object=Cup".
void TakeParameters(const std::vector<std::string>& rest, PlanOptions& plan) {
  for (std::size_t at = 0; at < rest.size(); ++at) {
    if (!rest[at].starts_with("--") || rest[at].size() < 3) {
      throw CLI::ExtrasError({rest[at]});
    }
    const std::string name = rest[at].substr(2);
    if (name.find('=') != std::string::npos) {
      plan.set.push_back(name);
    } else if (at + 1 < rest.size() && !rest[at + 1].starts_with("--")) {
      plan.set.push_back(name + "=" + rest[++at]);
    } else {
      throw CLI::ValidationError(rest[at],
                                 "is no option of lares plan, and as a parameter of the "
                                 "recipe it has no value");
    }
  }
}

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
  for (const std::string& setting : plan.set) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size()) {
      throw CLI::ValidationError("--set", "write it as NAME=VALUE, not '" + setting + "'");
    }
    body["set"][setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  if (plan.sequential) body["sequential"] = true;
  if (!plan.from.empty()) body["from"] = plan.from;
  if (!plan.done.empty()) body["done"] = plan.done;
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
  if (document.contains("nearest_robots")) {
    for (const Json& robot : document["nearest_robots"]) {
      std::string added;
      for (const Json& item : robot.value("add", Json::array())) {
        added += (added.empty() ? "" : ", ") + TextOf(item, "text");
      }
      text += "robot that nearly can: " + TextOf(robot, "id") + ", with " + added + "\n";
    }
  }
  Print(text);
}

void MakePlan(const PlanOptions& plan, const Options& options) {
  if (!plan.package.empty()) CheckPackageFolder(plan.package);
  Remote remote(options.server);
  http::ClientRequest request;
  request.method = "POST";
  request.path = "/v1/plans";
  request.query.emplace("as", options.json || !plan.package.empty() ? "json" : plan.as);
  request.headers.Set("Content-Type", "application/json");
  request.body = RequestBody(plan).dump();
  http::ClientResponse response;
  try {
    response = remote.Send(request);
  } catch (const RemoteError& error) {
    if (ExitCodeOf(error.problem_code()) == ExitCode::kNoPlan && !options.json) PrintRefusal(error);
    throw;
  }
  if (!plan.package.empty()) {
    return SavePackage(remote, response.body, plan.package, options);
  }
  if (plan.out.empty()) return Print(response.body);
  WriteFileAtomically(plan.out, response.body);
  Print("wrote " + plan.out + "\n");
}

}  // namespace

void AddPlan(CLI::App& app, Options& options) {
  auto* command = AddCommand(
      app, "plan", "A plan of a task for one robot, or why there is none",
      "  lares plan FindBottle --robot pioneer\n"
      "  lares plan FindBottle --robot pioneer --environment hospital-room --as bt-xml --out "
      "plan.xml\n"
      "  lares plan ObjectSearch --object Cup --robot scout --environment flat\n"
      "  lares plan FindBottle --robot PR2 --as dot | dot -Tsvg > plan.svg\n"
      "  lares plan FindBottle --robot pioneer --environment hospital-room --package mission");
  auto plan = std::make_shared<PlanOptions>();
  // Both are needed, unless it is `lares plan diff`: CLI11 would ask for them there too.
  command->add_option("TASK", plan->task, "recipe's id, or the task's IRI, label or local name");
  command->add_option("--robot", plan->robot, "id, IRI or label");
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
  command->add_option("--set", plan->set,
                      "NAME=VALUE: a parameter of the recipe, or another value of a skill's input; "
                      "may be repeated. --NAME VALUE is the same");
  command->add_flag("--sequential", plan->sequential, "run nothing side by side");
  command->add_option("--from", plan->from, "make the plan anew from this step on");
  command->add_option("--done", plan->done, "a step that is done already; may be repeated")
      ->allow_extra_args(false);
  // What is no option here is a parameter, so the general options must be known here too.
  command->allow_extras();
  command->fallthrough(false);
  command->add_option("--server", options.server.url, "address of the server")->group("General");
  AddServerOptions(*command, options);
  command->add_flag("--json", options.json, "print the server's JSON")->group("General");
  command->add_option("--out", plan->out, "file to write instead of standard output");
  command
      ->add_option("--package", plan->package,
                   "folder to write the plan into with all that it needs: object models, a grid "
                   "for this robot, the environment's layers")
      ->excludes("--out")
      ->excludes("--as");
  command->callback([=, &options] {
    if (command->got_subcommand("diff")) return;
    if (plan->task.empty()) throw CLI::RequiredError("TASK");
    if (plan->robot.empty()) throw CLI::RequiredError("--robot");
    TakeParameters(command->remaining(), *plan);
    MakePlan(*plan, options);
  });
}

}  // namespace lares::cli
