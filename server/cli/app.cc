#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"
#include "server/http/url.h"

namespace lares::cli {
namespace {

int ParseAndRun(CLI::App& app, const Options& options, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return static_cast<int>(ExitCode::kOk);
  } catch (const CLI::ParseError& error) {
    // Asking for help is no fault; everything else is one of usage.
    return static_cast<int>(app.exit(error) == 0 ? ExitCode::kOk : ExitCode::kUsage);
  } catch (const RemoteError& error) {
    if (options.json) Print(error.document());
    throw;
  }
}

}  // namespace

void AddServerOptions(CLI::App& app, Options& options) {
  app.add_option("--token-file", options.server.token_file,
                 "file with the token, when LARES_TOKEN does not hold it")
      ->group("General");
  app.add_option("--ca", options.server.ca_file,
                 "certificates (PEM) that may vouch for an https server, instead of the system's")
      ->envname("LARES_CA")
      ->group("General");
}

CLI::App* AddCommand(CLI::App& parent, const std::string& name, const std::string& what,
                     const std::string& examples) {
  CLI::App* command = parent.add_subcommand(name, what);
  command->fallthrough();
  command->footer("Examples:\n" + examples);
  return command;
}

int Run(int argc, const char* const* argv) {
  try {
    Options options;
    CLI::App app("Lares: knowledge-based semantic mapping for service robots", "lares");
    app.add_option("--server", options.server.url, "address of the server")
        ->envname("LARES_SERVER")
        ->check([](const std::string& text) {
          try {
            http::ParseBaseUrl(text);
            return std::string();
          } catch (const Error& error) {
            return std::string(error.what());
          }
        })
        ->capture_default_str();
    AddServerOptions(app, options);
    app.add_flag("--json", options.json, "print the server's JSON");
    app.set_version_flag("--version", "lares " LARES_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Examples:\n  lares serve\n  lares plan FindBottle --robot pioneer\n"
        "  lares where Cup\nEvery command has its own --help; see also lares help "
        "exit-codes");
    AddServe(app, options);
    AddRecipe(app, options);
    AddRobot(app, options);
    AddSkill(app, options);
    AddPlan(app, options);
    AddPlanDiff(*app.get_subcommand("plan"), options);
    AddWhere(app, options);
    AddEnvironment(app, options);
    AddPrior(app, options);
    AddObjectModel(app, options);
    AddOntology(app, options);
    AddProlog(app, options);
    AddQuarantine(app, options);
    AddSparql(app, options);
    AddWhy(app, options);
    AddDistance(app, options);
    AddWatch(app, options);
    AddStore(app, options);
    AddToken(app, options);
    AddAudit(app, options);
    AddStatus(app, options);
    AddCompletion(app);
    AddMan(app);
    return ParseAndRun(app, options, argc, argv);
  } catch (const std::exception& error) {
    PrintError(error);
    return static_cast<int>(ExitCodeOf(error));
  } catch (...) {
    std::fputs("lares: an unknown fault\n", stderr);
    return static_cast<int>(ExitCode::kInternal);
  }
}

}  // namespace lares::cli
