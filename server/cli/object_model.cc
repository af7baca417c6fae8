#include <CLI/CLI.hpp>
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

void ListModels(const std::string& class_name, const Options& options) {
  Remote remote(options.server);
  std::multimap<std::string, std::string> query;
  if (!class_name.empty()) query.emplace("class", class_name);
  const Json list = remote.GetList(kCollection, query);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) return Print("no object model is stored\n");
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    const Json details = item.value("details", Json::object());
    rows.push_back({TextOf(item, "id"), std::to_string(item.value("version", 0)),
                    LabelsOf(item.value("classes", Json::array())),
                    std::to_string(details.value("files", Json::array()).size())});
  }
  Print(FormatTable({"ID", "VERSION", "MODEL OF", "FILES"}, rows));
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
                           "  lares object-model list --class Cabinet");
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
                          "  lares object-model list\n  lares object-model list --class Bottle");
  auto class_name = std::make_shared<std::string>();
  list->add_option("--class", *class_name, "only models of this class or a subclass");
  list->callback([=, &options] { ListModels(*class_name, options); });

  auto* get = AddCommand(*model, "get", "A model's description, or with --out all its files",
                         "  lares object-model get cabinet1 --out cabinet1");
  auto wanted = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  get->add_option("ID", *wanted)->required();
  get->add_option("--out", *out, "folder to write into");
  get->callback([=, &options] { GetModel(*wanted, *out, options); });
}

}  // namespace lares::cli
