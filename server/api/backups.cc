// The store itself, over HTTP: copies of it, and whether all of it holds.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/json_body.h"

namespace lares::api {
namespace {

namespace fs = std::filesystem;
using PlainJson = nlohmann::json;

constexpr std::uint64_t kMaxBody = 64 * 1024;

fs::path BackupFolder(const Context& context) {
  if (context.backups.empty()) {
    throw Error(Code::kForbidden, "this server has no folder for backups")
        .WithHint("start it with --backups DIR");
  }
  return context.backups;
}

std::string ReadName(const http::Request& request) {
  const PlainJson json = ReadJsonObject(http::ReadWholeBody(request, kMaxBody), {"name"});
  if (!json.contains("name") || !json["name"].is_string()) {
    throw Error(Code::kInvalid, "'name' must be a text");
  }
  const std::string name = json["name"].get<std::string>();
  if (!IsIdentifier(name)) {
    throw Error(Code::kInvalid, "'" + Shortened(name, 60) +
                                    "' is no name of a backup: letters, "
                                    "digits, '.', '_' and '-', not beginning with '.' or '-'");
  }
  return name;
}

Json ToJson(const std::string& name, const fs::path& folder, const store::BackupReport& report) {
  return {{"name", name},
          {"folder", folder.string()},
          {"digest", report.digest},
          {"bytes", report.bytes},
          {"documentVersions", report.documents},
          {"environmentVersions", report.environments},
          {"blobs", report.blobs}};
}

http::Response MakeBackup(const http::Request& request, Context& context) {
  const std::string name = ReadName(request);
  const fs::path folder = BackupFolder(context) / name;
  return JsonAnswer(ToJson(name, folder, context.store.Backup(folder, {})), 201);
}

// Finished ones only, by name.
http::Response ListBackups(const http::Request&, Context& context) {
  Json json{{"items", Json::array()}};
  std::error_code error;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(context.backups, error)) {
    if (fs::is_regular_file(entry.path() / "backup.json", error)) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  for (const fs::path& folder : folders) {
    Json item{{"name", folder.filename().string()}, {"folder", folder.string()}};
    const Json manifest = Json::parse(ReadFile(folder / "backup.json"), nullptr, false);
    if (manifest.is_object()) item.update(manifest);
    json["items"].push_back(std::move(item));
  }
  return JsonAnswer(json);
}

http::Response Verify(const http::Request&, Context& context) {
  const std::vector<std::string> problems = context.store.Verify();
  return JsonAnswer(Json{{"problems", problems}, {"digest", context.store.Digest()}});
}

}  // namespace

void AddBackupRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* method, const char* path, const char* operation, auto handler,
                       bool has_body) {
    router.Add(
        {method, path, operation,
         [handler, &context](const http::Request& request) { return handler(request, context); },
         has_body ? std::vector<std::string>{"application/json"} : std::vector<std::string>{},
         has_body ? kMaxBody : 0});
  };
  add("GET", "/v1/backups", "listBackups", ListBackups, false);
  add("POST", "/v1/backups", "makeBackup", MakeBackup, true);
  add("POST", "/v1/verification", "verifyStore", Verify, false);
}

}  // namespace lares::api
