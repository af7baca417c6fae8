#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "base/error.h"
#include "base/text.h"
#include "mapping/environment/layer_format.h"
#include "server/api/uploads.h"
#include "server/cli/command.h"
#include "server/cli/download.h"
#include "server/cli/grid_files.h"
#include "server/cli/patience.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"
#include "server/cli/resumable.h"
#include "server/cli/temporary_folder.h"
#include "server/http/media_type.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

struct PutOptions {
  std::string id;
  std::string type;
  std::string label;
  std::string author;
  std::string note;
  std::string robot;
  std::string mission;
  int parent = 0;
  std::string if_match;
  std::vector<std::string> layers;  // NAME=FILE
  std::vector<std::string> removed;
  bool editor = false;
  bool quarantine = false;
  bool resume = false;
  int patience_s = 60;
};

// Layers from this size on are sent so that a broken connection costs little.
constexpr std::uint64_t kResumableBytes = std::uint64_t{16} << 20;

// A grid's YAML is sent together with its image, as one archive in `temporary`.
http::FormPart LayerPart(const std::string& layer, const fs::path& temporary) {
  const std::size_t equals = layer.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == layer.size()) {
    throw CLI::ValidationError("--layer", "write it as NAME=FILE, not '" + layer + "'");
  }
  const std::string name = layer.substr(0, equals);
  if (!environment::IsLayerName(name)) {
    throw CLI::ValidationError("--layer", "'" + name + "' is no layer: use one of " +
                                              Join(environment::LayerNames(), ", "));
  }
  fs::path file = layer.substr(equals + 1);
  const std::string extension = ToLower(file.extension().string());
  if (name == "grid" && (extension == ".yaml" || extension == ".yml")) {
    const fs::path archive = temporary / (file.stem().string() + ".tar");
    PackGrid(file, archive);
    file = archive;
  }
  const std::string file_name = file.filename().string();
  return {name, "", file, file_name, http::MediaTypeOfFile(file_name)};
}

std::vector<http::FormPart> FormOf(const PutOptions& put, const fs::path& temporary) {
  std::vector<http::FormPart> parts;
  const auto field = [&parts](const char* name, const std::string& value) {
    if (!value.empty()) parts.push_back({name, value, {}, "", ""});
  };
  field("type", put.type);
  field("label", put.label);
  field("author", put.author);
  field("note", put.note);
  field("robot", put.robot);
  field("mission", put.mission);
  if (put.parent > 0) field("parent", std::to_string(put.parent));
  for (const std::string& removed : put.removed) field("remove", removed);
  for (const std::string& layer : put.layers) parts.push_back(LayerPart(layer, temporary));
  if (parts.empty()) throw CLI::ValidationError("--layer", "there is nothing to put");
  return parts;
}

std::string VersionSummary(const std::string& id, const Json& answer) {
  const Json& version = answer.at("version");
  std::string text = "environment " + id + ", version " +
                     std::to_string(version.value("number", 0)) + " (ETag " +
                     TextOf(version, "etag") + ")\n";
  for (const Json& layer : version.at("layers")) {
    text += "  " + TextOf(layer, "name") + "  " +
            FormatBytes(layer.value("size", std::uint64_t{0})) + "\n";
  }
  const auto objects = answer.value("objects", std::size_t{0});
  if (objects > 0) text += "  " + Plural(objects, "object") + " on the map\n";
  text += FormatRemarks(answer.at("repairs"), "  repaired:");
  text += FormatRemarks(answer.at("warnings"), "  warnings:");
  return text;
}

std::string AsideSummary(const std::string& id, const Json& answer) {
  return "semantic layer kept aside as " + TextOf(answer.at("document"), "id") + ", version " +
         std::to_string(answer.at("document").value("version", 0)) + "; environment " + id +
         " is as it was:\n  " + TextOf(answer, "quarantined") + "\n";
}

// Large files go ahead; what stays in the form refers to them.
std::vector<FinishedUpload> SendLargeFiles(Remote& remote, std::vector<http::FormPart>& parts,
                                           const ResumableOptions& options) {
  std::vector<FinishedUpload> uploads;
  for (http::FormPart& part : parts) {
    std::error_code error;
    const std::uint64_t size = part.file.empty() ? 0 : fs::file_size(part.file, error);
    if (error || size < kResumableBytes) continue;
    uploads.push_back(UploadFile(remote, "layer " + part.name, part.file, options));
    part.text = uploads.back().path;
    part.file.clear();
    part.content_type = std::string(api::kUploadReference);
  }
  return uploads;
}

std::string NewKey() {
  std::random_device random;
  std::string key = "lares-put";
  for (int i = 0; i < 4; ++i) key += "-" + std::to_string(random());
  return key;
}

// The key lets the server tell whether it has done this already, when the connection breaks before
// it has answered.
http::ClientResponse SendOnce(Remote& remote, http::ClientRequest request,
                              const http::Transfer& transfer, std::chrono::seconds patience_time,
                              bool was_there) {
  request.headers.Set("Idempotency-Key", NewKey());
  Patience patience(patience_time);
  while (true) {
    try {
      return remote.Send(request, transfer);
    } catch (const Error& error) {
      const bool away = dynamic_cast<const http::NoServerError*>(&error) != nullptr;
      if (!IsPassing(error) || (away && !was_there) || !patience.Wait()) throw;
      was_there = true;
    }
  }
}

void Put(const PutOptions& put, const Options& options) {
  const TemporaryFolder temporary(fs::temp_directory_path(), "lares-put-");
  http::ClientRequest request;
  request.method = "POST";
  request.path = PathOf("/v1/environments", {put.id, "versions"});
  if (put.editor) request.query.emplace("editor", "true");
  if (put.quarantine) request.query.emplace("quarantine", "true");
  if (put.if_match == "none") request.headers.Set("If-None-Match", "*");
  if (!put.if_match.empty() && put.if_match != "none") {
    request.headers.Set("If-Match", put.if_match);
  }
  Remote remote(options.server);
  ResumableOptions resumable;
  resumable.resume = put.resume;
  resumable.patience = std::chrono::seconds(put.patience_s);
  std::vector<http::FormPart> parts = FormOf(put, temporary.path());
  const StopOnSignal stop_on_signal;
  const std::vector<FinishedUpload> uploads = SendLargeFiles(remote, parts, resumable);
  request.body = http::EncodeForm(parts);
  Json answer;
  {
    ProgressBar bar("sending");
    http::Transfer transfer;
    transfer.uploaded = [&bar](std::uint64_t done, std::uint64_t all) {
      if (IsAskedToStop()) throw Error(Code::kIo, "interrupted");
      bar.Show(done, all);
    };
    answer =
        Json::parse(SendOnce(remote, request, transfer, resumable.patience, !uploads.empty()).body);
  }
  for (const FinishedUpload& upload : uploads) ForgetUpload(remote, upload, resumable);
  if (options.json) return PrintJson(answer);
  Print(answer.contains("quarantined") ? AsideSummary(put.id, answer)
                                       : VersionSummary(put.id, answer));
}

void Release(const std::string& id, bool editor, const Options& options) {
  http::ClientRequest request;
  request.method = "POST";
  request.path = PathOf("/v1/quarantine", {"environment." + id, "release"});
  if (editor) request.query.emplace("editor", "true");
  Remote remote(options.server);
  const Json answer = Json::parse(remote.Send(request).body);
  if (options.json) return PrintJson(answer);
  Print(VersionSummary(id, answer));
}

}  // namespace

void AddEnvironmentPut(CLI::App& environment, const Options& options) {
  auto* command = AddCommand(
      environment, "put", "Add a version; the first one creates the environment",
      "  lares environment put hospital-room --type HospitalRoom \\\n"
      "      --layer semantic=room.owl --layer octomap=room.bt\n"
      "  lares environment put lab --layer grid=map.yaml --note 'after moving the desk' \\\n"
      "      --if-match '\"lab-3\"'\n"
      "  lares environment put lab --layer cloud=hall.ply --resume");
  auto put = std::make_shared<PutOptions>();
  command->add_option("ID", put->id)->required();
  command->add_option("--layer", put->layers,
                      "NAME=FILE; may be repeated. semantic (RDF), octomap (.bt, .ot), grid "
                      "(map_server's .yaml, or a .tar with its image), cloud (.ply), trajectory "
                      "(TUM), features");
  command->add_option("--remove-layer", put->removed, "a layer the new version shall not have");
  command->add_option("--type", put->type, "class of the place: name, label or IRI");
  command->add_option("--label", put->label, "what people call it");
  command->add_option("--author", put->author, "who made this version");
  command->add_option("--note", put->note, "what is new in it");
  command->add_option("--robot", put->robot, "which robot made it");
  command->add_option("--mission", put->mission, "in which mission");
  command
      ->add_option("--parent", put->parent,
                   "the version that it was made from; of another one than the newest it becomes "
                   "a branch (see: lares environment merge)")
      ->check(CLI::PositiveNumber);
  command->add_option("--if-match", put->if_match,
                      "only if the newest version still has this ETag; 'none': only if the "
                      "environment is new");
  command->add_flag("--editor", put->editor, "you may say new things about terms of others");
  command->add_flag("--quarantine", put->quarantine,
                    "keep aside a semantic layer that contradicts what is known, instead of "
                    "refusing it; it must be the only layer");
  command->add_flag("--resume", put->resume,
                    "go on with the large layers that an earlier put of the same files left "
                    "unfinished");
  command
      ->add_option("--patience", put->patience_s,
                   "seconds to try again after the connection broke; layers from 16 MiB on go on "
                   "where they stopped")
      ->check(CLI::Range(0, 86400))
      ->capture_default_str();
  command->callback([=, &options] { Put(*put, options); });
}

void AddEnvironmentRelease(CLI::App& environment, const Options& options) {
  auto* command = AddCommand(
      environment, "release",
      "Take the semantic layer that was kept aside as a new version (see: lares quarantine)",
      "  lares environment release hospital-room\n"
      "  lares environment release --editor hospital-room");
  auto id = std::make_shared<std::string>();
  auto editor = std::make_shared<bool>(false);
  command->add_option("ID", *id)->required();
  command->add_flag("--editor", *editor, "you may say new things about terms of others");
  command->callback([=, &options] { Release(*id, *editor, options); });
}

}  // namespace lares::cli
