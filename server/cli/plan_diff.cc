#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr std::uintmax_t kMaxPlan_bytes = 8u << 20;

struct DiffOptions {
  std::vector<std::string> plans;  // two files, or one task
  std::vector<std::string> robots;
  std::vector<std::string> environments;
  std::vector<std::string> set;
  bool strict = false;
};

Json ReadPlanFile(const std::string& file) {
  std::string text;
  try {
    text = ReadLocalFile(file, kMaxPlan_bytes);
  } catch (const Error& error) {
    // Not as a fault of files: that exit code says that the plans differ.
    if (error.code() == Code::kIo) throw Error(Code::kNotFound, error.what());
    throw;
  }
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw Error(Code::kInvalid, file + " is no JSON");
  if (!json.is_object() || !json.contains("format")) {
    throw Error(Code::kInvalid, file + " holds no plan")
        .WithHint("write one with lares plan TASK --robot ROBOT --as json --out " + file);
  }
  return json;
}

// The first for a, the last for b: one name stands for both.
std::string Chosen(const std::vector<std::string>& names, bool first) {
  if (names.empty()) return "";
  return first ? names.front() : names.back();
}

Json RequestFor(const DiffOptions& diff, bool first) {
  Json request{{"task", diff.plans.front()}, {"robot", Chosen(diff.robots, first)}};
  const std::string environment = Chosen(diff.environments, first);
  if (!environment.empty()) request["environment"] = environment;
  if (diff.strict) request["strict"] = true;
  for (const std::string& setting : diff.set) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw CLI::ValidationError("--set", "write it as NAME=VALUE, not '" + setting + "'");
    }
    request["set"][setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return request;
}

Json RequestBody(const DiffOptions& diff) {
  if (diff.plans.size() == 2) {
    if (!diff.robots.empty() || !diff.environments.empty() || !diff.set.empty() || diff.strict) {
      throw CLI::ValidationError("lares plan diff", "two files are compared as they are");
    }
    return {{"a", ReadPlanFile(diff.plans[0])}, {"b", ReadPlanFile(diff.plans[1])}};
  }
  if (diff.robots.empty()) {
    throw CLI::ValidationError("lares plan diff", "name two files of plans, or a task and --robot");
  }
  if (diff.robots.size() > 2 || diff.environments.size() > 2) {
    throw CLI::ValidationError("lares plan diff", "two plans are compared, not more");
  }
  return {{"a", RequestFor(diff, true)}, {"b", RequestFor(diff, false)}};
}

void Compare(const DiffOptions& diff, const Options& options) {
  Remote remote(options.server);
  http::ClientRequest request;
  request.method = "POST";
  request.path = "/v1/plans/diff";
  request.query.emplace("as", options.json ? "json" : "text");
  request.headers.Set("Content-Type", "application/json");
  request.body = RequestBody(diff).dump();
  const http::ClientResponse response = remote.Send(request);
  Print(response.body);
  if (response.headers.Get("X-Plans-Equal") != "true") {
    throw DifferError("the plans differ");
  }
}

}  // namespace

void AddPlanDiff(CLI::App& plan, Options& options) {
  auto* command = AddCommand(
      plan, "diff",
      "What differs between two plans, and why: exit code 0 without a difference, 1 with",
      "  lares plan diff before.json after.json\n"
      "  lares plan diff ObjectSearch --set object=Cup --robot scout --robot helper\n"
      "  lares plan diff ObjectSearch --set object=Cup --robot scout --environment flat "
      "--environment suite");
  auto diff = std::make_shared<DiffOptions>();
  command->fallthrough(false);
  command->allow_extras(false);
  command->add_option("PLANS", diff->plans, "two files of plans in JSON, or one task")
      ->required()
      ->expected(1, 2);
  command->add_option("--robot", diff->robots, "of both plans, or once for each")
      ->allow_extra_args(false);
  command->add_option("--environment", diff->environments, "of both plans, or once for each")
      ->allow_extra_args(false);
  command->add_option("--set", diff->set, "NAME=VALUE: a parameter of the recipe, in both plans")
      ->allow_extra_args(false);
  command->add_flag("--strict", diff->strict, "do not take a capability on the robot maker's word");
  command->add_option("--server", options.server.url, "address of the server")->group("General");
  AddServerOptions(*command, options);
  command->add_flag("--json", options.json, "print the server's JSON")->group("General");
  command->callback([=, &options] { Compare(*diff, options); });
}

}  // namespace lares::cli
