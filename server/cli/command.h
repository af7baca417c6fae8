// What every command is given, and how they are registered.
#pragma once

#include <functional>
#include <string>

#include "server/cli/remote.h"

namespace CLI {
class App;
}

namespace lares::cli {

struct Options {
  ServerAddress server;
  bool json = false;  // print what the server answered
};

// Each adds its subcommands to `app`; a command runs as CLI11's callback and throws on failure.
// `options` outlives the app.
void AddServe(CLI::App& app, const Options& options);
void AddRecipe(CLI::App& app, const Options& options);
void AddRecipeRobots(CLI::App& recipe, const Options& options);
void AddRobot(CLI::App& app, const Options& options);
void AddRobotQuestions(CLI::App& robot, const Options& options);
void AddOntology(CLI::App& app, const Options& options);
void AddOntologyConvert(CLI::App& ontology);
void AddOntologyCheck(CLI::App& ontology, const Options& options);
void AddEnvironment(CLI::App& app, const Options& options);
void AddEnvironmentPut(CLI::App& environment, const Options& options);
void AddEnvironmentRelease(CLI::App& environment, const Options& options);
void AddEnvironmentVersions(CLI::App& environment, const Options& options);
void AddRobotPins(CLI::App& robot, const Options& options);
void AddEnvironmentGet(CLI::App& environment, const Options& options);
void AddObjectModel(CLI::App& app, const Options& options);
void AddObjectModelTypical(CLI::App& model, const Options& options);
void AddSkill(CLI::App& app, const Options& options);
void AddPlan(CLI::App& app, Options& options);
void AddPlanDiff(CLI::App& plan, Options& options);  // below `lares plan`
void AddToken(CLI::App& app, const Options& options);
void AddAudit(CLI::App& app, const Options& options);
void AddPrior(CLI::App& app, const Options& options);
void AddProlog(CLI::App& app, const Options& options);
void AddQuarantine(CLI::App& app, const Options& options);
void AddWhere(CLI::App& app, const Options& options);
void AddSparql(CLI::App& app, const Options& options);
void AddWatch(CLI::App& app, const Options& options);
void AddWhy(CLI::App& app, const Options& options);  // why and why-not
void AddDistance(CLI::App& app, const Options& options);
void AddStore(CLI::App& app, const Options& options);
void AddStatus(CLI::App& app, const Options& options);
void AddCompletion(CLI::App& app);  // both print what the tree below `app`, the root, says
void AddMan(CLI::App& app);

// --token-file and --ca.
void AddServerOptions(CLI::App& app, Options& options);

// A subcommand with its examples below the help.
CLI::App* AddCommand(CLI::App& parent, const std::string& name, const std::string& what,
                     const std::string& examples);

// Runs the command line; the process's exit code. Never throws.
int Run(int argc, const char* const* argv);

}  // namespace lares::cli
