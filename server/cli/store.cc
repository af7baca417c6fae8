// The store itself: looked at, copied, brought back. With --data or --store these commands open it
// themselves; `verify` and `backup` ask the running server otherwise.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"
#include "server/cli/store_place.h"
#include "server/store/store.h"

namespace lares::cli {
namespace {

Json ToJson(const store::BackupReport& report) {
  return {{"digest", report.digest},
          {"bytes", report.bytes},
          {"documentVersions", report.documents},
          {"environmentVersions", report.environments},
          {"blobs", report.blobs}};
}

std::string Summary(const store::BackupReport& report) {
  return std::to_string(report.documents) + " versions of documents, " +
         std::to_string(report.environments) + " of environments, " + FormatBytes(report.bytes) +
         "\ndigest " + report.digest + "\n";
}

Json VerifyHere(const StorePlace& place) {
  const std::unique_ptr<store::Store> store = OpenStore(place);
  return {{"problems", store->Verify()}, {"digest", store->Digest()}};
}

Json VerifyRunning(const Options& options) {
  return Remote(options.server).SendJson("POST", "/v1/verification", Json());
}

void Verify(const StorePlace& place, const Options& options) {
  const Json found = IsNamed(place) ? VerifyHere(place) : VerifyRunning(options);
  const auto problems = found.at("problems").get<std::vector<std::string>>();
  if (options.json) {
    PrintJson(found);
  } else if (problems.empty()) {
    Print("every hash and every reference holds\ndigest " + TextOf(found, "digest") + "\n");
  } else {
    for (const std::string& problem : problems) Print(problem + "\n");
  }
  if (!problems.empty()) {
    throw FindingsError(std::to_string(problems.size()) +
                        (problems.size() == 1 ? " thing is" : " things are") + " wrong");
  }
}

void Backup(const StorePlace& place, const std::string& folder, const Options& options) {
  const std::unique_ptr<store::Store> store = OpenStore(place);
  ProgressBar progress("backing up");
  const store::BackupReport report = store->Backup(
      folder, [&](std::uint64_t done, std::uint64_t all) { progress.Show(done, all); });
  if (options.json) return PrintJson(ToJson(report));
  Print("backed up to '" + folder + "': " + Summary(report));
}

void BackupRunning(const std::string& name, const Options& options) {
  const Json report = Remote(options.server).SendJson("POST", "/v1/backups", Json{{"name", name}});
  if (options.json) return PrintJson(report);
  Print("backed up to '" + TextOf(report, "folder") + "' on the server's machine\ndigest " +
        TextOf(report, "digest") + "\n");
}

void Restore(const StorePlace& place, const std::string& backup, const Options& options) {
  const std::unique_ptr<store::Store> store = OpenStore(place);
  ProgressBar progress("restoring");
  const store::BackupReport report = store->FillFrom(
      backup, [&](std::uint64_t done, std::uint64_t all) { progress.Show(done, all); });
  if (options.json) return PrintJson(ToJson(report));
  Print("restored: " + Summary(report));
}

void Migrate(const StorePlace& place, const Options& options) {
  const store::MigrationReport report = store::MigrateSqliteStore({DataFolder(place)});
  if (options.json) {
    return PrintJson({{"from", report.from}, {"to", report.to}, {"kept", report.kept_file}});
  }
  if (report.from == report.to) {
    return Print("the store has schema " + std::to_string(report.to) + " already\n");
  }
  Print("migrated from schema " + std::to_string(report.from) + " to " + std::to_string(report.to) +
        "; the database as it was is in '" + report.kept_file.string() + "'\n");
}

}  // namespace

void AddStore(CLI::App& app, const Options& options) {
  auto* store = AddCommand(app, "store", "Verify, back up, restore and migrate what is kept",
                           "  lares store backup monday\n"
                           "  lares store restore lares-data/backups/monday --data new-store");
  store->require_subcommand(1);
  auto place = std::make_shared<StorePlace>();
  auto folder = std::make_shared<std::string>();
  const auto add = [&](const char* name, const char* what, const char* examples, auto action) {
    auto* command = AddCommand(*store, name, what, examples);
    AddStorePlace(*command, *place);
    command->callback(action);
    return command;
  };
  add("verify", "Read everything: every hash, every reference, the database itself",
      "  lares store verify                     of the running server\n"
      "  lares store verify --data lares-data   without a server",
      [=, &options] { Verify(*place, options); });
  add("backup", "A copy of everything as it is at one moment",
      "  lares store backup monday                          of the running server, beside its "
      "data\n"
      "  lares store backup /backups/monday --data DIR      without a server",
      [=, &options] {
        return IsNamed(*place) ? Backup(*place, *folder, options) : BackupRunning(*folder, options);
      })
      ->add_option("NAME", *folder,
                   "the backup's name; with --data or --store its folder, a new one")
      ->required();
  add("restore", "Fill a new store from a backup",
      "  lares store restore lares-data/backups/monday --data new-store",
      [=, &options] { Restore(*place, *folder, options); })
      ->add_option("BACKUP", *folder, "a folder that `lares store backup` made")
      ->required();
  add("migrate", "Bring a store that an older program made to this one's schema",
      "  lares store migrate --data lares-data", [=, &options] { Migrate(*place, options); });
}

}  // namespace lares::cli
