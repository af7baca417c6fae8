#include <CLI/CLI.hpp>
#include <array>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/hash.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"
#include "server/http/media_type.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCollection = "/v1/object-models";

bool IsDescription(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".owl" || extension == ".rdf" || extension == ".ttl";
}

void PutModel(const std::vector<std::string>& files, const std::string& id, bool recover,
              const Options& options) {
  std::vector<http::FormPart> parts;
  fs::path description;
  for (const std::string& name : files) {
    const fs::path file(name);
    const bool describes = description.empty() && IsDescription(file);
    if (describes) description = file;
    parts.push_back({describes ? "description" : "file", "", file, file.filename().string(),
                     http::MediaTypeOfFile(file.filename().string())});
  }
  if (description.empty()) {
    throw Error(Code::kInvalid, "none of the files is a description (.owl, .rdf or .ttl)");
  }
  http::ClientRequest request;
  request.method = "PUT";
  request.path = PathOf(kCollection, {IdFor(description, id)});
  if (recover) request.query.emplace("recover", "true");
  request.body = http::EncodeForm(parts);
  Remote remote(options.server);
  ProgressBar bar("sending");
  http::Transfer transfer;
  transfer.uploaded = [&bar](std::uint64_t done, std::uint64_t all) { bar.Show(done, all); };
  const Json answer = Json::parse(remote.Send(request, transfer).body);
  if (options.json) return PrintJson(answer);
  const Json& document = answer.at("document");
  Print("object model " + TextOf(document, "id") + ", version " +
        std::to_string(document.value("version", 0)) + ", " + Plural(files.size() - 1, "file") +
        "\n" + FormatRemarks(answer.at("repairs"), "  repaired:") +
        FormatRemarks(answer.at("warnings"), "  warnings:"));
}

std::string LabelsOf(const Json& resources) {
  std::string labels;
  for (const Json& resource : resources) {
    labels += (labels.empty() ? "" : ", ") + TextOf(resource, "label");
  }
  return labels;
}

// "0.68 × 0.28 × 2 m", width, height and depth where these are known.
std::string FormatExtents(const Json& extents) {
  if (!extents.is_object()) return "";
  std::string text;
  for (const auto& names :
       {std::array{"width_m", "height_m", "depth_m"}, std::array{"x_m", "y_m", "z_m"}}) {
    if (!extents.contains(names[0])) continue;
    for (const char* name : names) {
      char side[32];
      std::snprintf(side, sizeof side, "%.3g", extents.value(name, 0.0));
      text += (text.empty() ? "" : " × ") + std::string(side);
    }
  }
  return text + " m";
}

void ListModels(const std::map<std::string, std::string>& asked, const Options& options) {
  Remote remote(options.server);
  std::multimap<std::string, std::string> query;
  for (const auto& [name, value] : asked) {
    if (!value.empty()) query.emplace(name, value);
  }
  const Json list = remote.GetList(kCollection, query);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) {
    return Print(query.empty() ? "no object model is stored\n"
                               : "no stored object model is like that\n");
  }
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    const Json details = item.value("details", Json::object());
    std::string of = LabelsOf(item.value("classes", Json::array()));
    if (item.contains("probability")) of += " " + FormatPercent(item.value("probability", 0.0));
    if (TextOf(item, "fit") == "more-general") of += " (more general)";
    rows.push_back({TextOf(item, "id"), std::to_string(item.value("version", 0)), of,
                    LabelsOf(item.value("algorithms", Json::array())),
                    FormatExtents(item.value("extents", Json())),
                    std::to_string(details.value("files", Json::array()).size())});
  }
  Print(FormatTable({"ID", "VERSION", "MODEL OF", "ALGORITHM", "SIZE", "FILES"}, rows));
}

void GetModel(const std::string& id, const std::string& out, const Options& options) {
  Remote remote(options.server);
  const std::string path = PathOf(kCollection, {id});
  const Json document = remote.GetJson(path, {{"as", "info"}});
  if (options.json || out.empty()) return PrintJson(document);
  fs::create_directories(out);
  const auto save = [&](const std::string& name, const std::string& from,
                        const std::string& sha256) {
    const std::string bytes = remote.Send({"GET", from, {}, {}, {}}).body;
    if (Sha256Hex(bytes) != sha256) throw Error(Code::kIo, name + " arrived damaged");
    // A file name of the server's is a name, never a path.
    WriteFileAtomically(fs::path(out) / fs::path(name).filename(), bytes);
    Print("wrote " + (fs::path(out) / fs::path(name).filename()).string() + "\n");
  };
  std::string description = TextOf(document, "file_name");
  if (description.empty()) description = id + ".owl";
  save(description, path, TextOf(document, "sha256"));
  const Json files = document.at("details").value("files", Json::array());
  for (const Json& file : files) {
    const std::string name = TextOf(file, "file_name");
    save(name, PathOf(path + "/files", {name}), TextOf(file, "sha256"));
  }
}

}  // namespace

void AddObjectModel(CLI::App& app, const Options& options) {
  auto* model = AddCommand(app, "object-model", "Object models: what recognises an object",
                           "  lares object-model put cabinet.owl face1.png face1.ply\n"
                           "  lares object-model list --class Cabinet\n"
                           "  lares object-model typical HospitalRoom");
  model->require_subcommand(1);

  auto* put = AddCommand(*model, "put", "Store a model: its description and its files",
                         "  lares object-model put cabinet.owl face1.png --id cabinet1");
  auto files = std::make_shared<std::vector<std::string>>();
  auto id = std::make_shared<std::string>();
  auto recover = std::make_shared<bool>(false);
  put->add_option("FILE", *files, "the description (.owl, .rdf, .ttl) and the model's files")
      ->required();
  put->add_option("--id", *id, "its id (default: the description's stem)");
  put->add_flag("--recover", *recover, "repair known faults of RDF/XML and list each repair");
  put->callback([=, &options] { PutModel(*files, *id, *recover, options); });

  auto* list = AddCommand(*model, "list", "List the stored models",
                          "  lares object-model list\n  lares object-model list --class Bottle\n"
                          "  lares object-model list --room HospitalRoom --maker RoboEarth");
  auto asked = std::make_shared<std::map<std::string, std::string>>();
  list->add_option("--class", (*asked)["class"],
                   "models of this class, a subclass, or something more general");
  list->add_option("--room", (*asked)["room"], "models of what is typical of this kind of room");
  list->add_option("--maker", (*asked)["maker"], "made by: IRI, or a part of the name");
  list->add_option("--algorithm", (*asked)["algorithm"], "for this kind of program");
  list->add_option("--kind", (*asked)["kind"], "this kind of model, such as PlanarObjectModel");
  list->callback([=, &options] { ListModels(*asked, options); });

  auto* get = AddCommand(*model, "get", "A model's description, or with --out all its files",
                         "  lares object-model get cabinet1 --out cabinet1");
  auto wanted = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  get->add_option("ID", *wanted)->required();
  get->add_option("--out", *out, "folder to write into");
  get->callback([=, &options] { GetModel(*wanted, *out, options); });
  AddObjectModelTypical(*model, options);
}

}  // namespace lares::cli
