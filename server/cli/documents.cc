#include "server/cli/documents.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/text.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"
#include "server/http/media_type.h"

namespace lares::cli {
namespace {

std::string Summary(const DocumentCommand& command, const Json& answer) {
  const Json& document = answer.at("document");
  if (answer.contains("quarantined")) {
    return command.noun + " kept aside as " + TextOf(document, "id") + ", version " +
           std::to_string(document.value("version", 0)) + ":\n  " + TextOf(answer, "quarantined") +
           "\n";
  }
  std::string text = command.noun + " " + TextOf(document, "id") + ", version " +
                     std::to_string(document.value("version", 0)) + ": " +
                     Plural(answer.value("statements", std::size_t{0}), "statement") + " read, " +
                     std::to_string(answer.value("inferred", std::size_t{0})) + " inferred\n";
  for (const Json& task : answer.value("tasks", Json::array())) {
    if (!task.value("top_level", true)) continue;
    const std::string name(LocalName(TextOf(task, "iri")));
    const std::string label = TextOf(task, "label");
    text += "  task " + name + (label == name ? "" : " '" + label + "'") + " (" +
            Plural(task.at("steps").size(), "step") + ", " + TextOf(task, "form") + ")\n";
  }
  for (const Json& robot : answer.value("robots", Json::array())) {
    text += "  robot " + TextOf(robot, "label") + " <" + TextOf(robot, "iri") + ">\n";
  }
  for (const Json& skill : answer.value("skill_templates", Json::array())) {
    text += "  skill template " + TextOf(skill, "label") + " <" + TextOf(skill, "iri") + ">\n";
  }
  const Json repairs = answer.value("repairs", Json::array());
  text += FormatRemarks(repairs, "  repaired (the original is kept):");
  text += FormatRemarks(answer.value("warnings", Json::array()), "  warnings:");
  if (command.more_summary) text += command.more_summary(answer);
  return text;
}

Json PutOne(Remote& remote, const DocumentCommand& command, const std::filesystem::path& file,
            const PutOptions& put) {
  http::ClientRequest request;
  request.method = "PUT";
  request.path = PathOf(command.collection, {IdFor(file, put.id)});
  request.query = put.query;
  request.query.emplace("file_name", file.filename().string());
  if (put.recover) request.query.emplace("recover", "true");
  if (put.editor) request.query.emplace("editor", "true");
  if (put.quarantine) request.query.emplace("quarantine", "true");
  request.headers.Set("Content-Type", http::MediaTypeOfFile(file.filename().string()));
  if (!put.if_match.empty()) {
    request.headers.Set(put.if_match == "none" ? "If-None-Match" : "If-Match",
                        put.if_match == "none" ? "*" : put.if_match);
  }
  request.body = ReadLocalFile(file, 256u << 20);
  return Json::parse(remote.Send(request).body);
}

}  // namespace

std::string IdFor(const std::filesystem::path& file, const std::string& id) {
  const std::string chosen = id.empty() ? file.stem().string() : id;
  if (IsIdentifier(chosen)) return chosen;
  throw Error(Code::kInvalid, "'" + chosen +
                                  "' is no id: 1 to 128 of A-Z a-z 0-9 . _ -, the "
                                  "first not . or -")
      .WithHint("give one with --id");
}

void PutDocuments(const DocumentCommand& command, const PutOptions& put, const Options& options) {
  if (!put.id.empty() && put.files.size() > 1) {
    throw CLI::ValidationError("--id", "names one document, but several files are given");
  }
  Remote remote(options.server);
  std::exception_ptr first;
  Json answers = Json::array();
  for (const std::string& file : put.files) {
    try {
      answers.push_back(PutOne(remote, command, file, put));
      if (!options.json) Print(Summary(command, answers.back()));
    } catch (const http::NoServerError&) {
      throw;
    } catch (const std::exception& error) {
      if (put.files.size() == 1) throw;
      if (first) PrintError(error);
      if (!first) first = std::current_exception();
    }
  }
  if (options.json) PrintJson(put.files.size() == 1 ? answers.front() : answers);
  if (first) std::rethrow_exception(first);
}

void ListDocuments(const DocumentCommand& command, const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(command.collection);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) return Print("no " + command.noun + " is stored\n");
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    rows.push_back({TextOf(item, "id"), std::to_string(item.value("version", 0)),
                    FormatTime(TextOf(item, "received")),
                    FormatBytes(item.value("size", std::uint64_t{0})), command.cell(item)});
  }
  Print(FormatTable({"ID", "VERSION", "RECEIVED", "SIZE", command.column}, rows));
}

void GetDocument(const DocumentCommand& command, const std::string& id, int version,
                 const std::string& out, const Options& options) {
  Remote remote(options.server);
  http::ClientRequest request;
  request.path = PathOf(command.collection, {id});
  if (version > 0) request.query.emplace("version", std::to_string(version));
  if (options.json) {
    request.query.emplace("as", "info");
    return Print(remote.Send(request).body);
  }
  const http::ClientResponse response = remote.Send(request);
  if (out.empty()) return Print(response.body);
  WriteFileAtomically(out, response.body);
  Print("wrote " + out + " (" + FormatBytes(response.body.size()) + ")\n");
}

void RemoveDocuments(const DocumentCommand& command, const std::vector<std::string>& ids,
                     const Options& options) {
  Remote remote(options.server);
  Json removed = Json::array();
  for (const std::string& id : ids) {
    http::ClientRequest request;
    request.method = "DELETE";
    request.path = PathOf(command.collection, {id});
    remote.Send(request);
    removed.push_back(id);
    if (!options.json) Print("removed " + command.noun + " " + id + "\n");
  }
  if (options.json) PrintJson({{"removed", removed}});
}

void ReleaseDocuments(const DocumentCommand& command, const std::vector<std::string>& ids,
                      bool editor, const Options& options) {
  Remote remote(options.server);
  Json answers = Json::array();
  const std::string& kind = command.kind.empty() ? command.noun : command.kind;
  for (const std::string& id : ids) {
    http::ClientRequest request;
    request.method = "POST";
    request.path = PathOf("/v1/quarantine", {kind + "." + id, "release"});
    if (editor) request.query.emplace("editor", "true");
    answers.push_back(Json::parse(remote.Send(request).body));
    if (!options.json) Print(Summary(command, answers.back()));
  }
  if (options.json) PrintJson(answers);
}

void AddDocumentCommands(CLI::App& app, const DocumentCommand& command, const Options& options,
                         const std::string& example_file) {
  const std::string stem = std::filesystem::path(example_file).stem().string();
  const std::string lares = "  lares " + command.noun + " ";

  auto* put =
      AddCommand(app, "put", "Store " + command.noun + " files",
                 lares + "put " + example_file + "\n" + lares + "put --recover " + example_file +
                     "\n" + lares + "put --id my-" + stem + " " + example_file);
  auto put_options = std::make_shared<PutOptions>();
  put->add_option("FILE", put_options->files, command.files)->required();
  if (command.more_options) command.more_options(*put, *put_options);
  put->add_option("--id", put_options->id, "another id (with one file)");
  put->add_flag("--recover", put_options->recover,
                "repair known faults of RDF/XML and list each repair");
  put->add_flag("--editor", put_options->editor, "you may say new things about terms of others");
  put->add_flag("--quarantine", put_options->quarantine,
                "keep aside what contradicts what is known, instead of refusing it");
  put->add_option("--if-match", put_options->if_match,
                  "only if the stored one still has this ETag; 'none': only if there is none");
  put->callback([=, &options] { PutDocuments(command, *put_options, options); });

  auto* list = AddCommand(app, "list", "List what is stored", lares + "list");
  list->callback([=, &options] { ListDocuments(command, options); });

  auto* get = AddCommand(app, "get", "The document as it was received",
                         lares + "get " + stem + "\n" + lares + "get " + stem + " --out copy.owl");
  auto id = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto version = std::make_shared<int>(0);
  get->add_option("ID", *id)->required();
  get->add_option("--version", *version, "an older version")->check(CLI::PositiveNumber);
  get->add_option("--out", *out, "file to write instead of standard output");
  get->callback([=, &options] { GetDocument(command, *id, *version, *out, options); });

  auto* remove = AddCommand(app, "remove", "Remove from lists and answers; versions are kept",
                            lares + "remove " + stem);
  auto ids = std::make_shared<std::vector<std::string>>();
  remove->add_option("ID", *ids)->required();
  remove->callback([=, &options] { RemoveDocuments(command, *ids, options); });

  auto* release = AddCommand(app, "release", "Take what was kept aside (see: lares quarantine)",
                             lares + "release " + stem + "\n" + lares + "release --editor " + stem);
  auto released = std::make_shared<std::vector<std::string>>();
  auto editor = std::make_shared<bool>(false);
  release->add_option("ID", *released)->required();
  release->add_flag("--editor", *editor, "you may say new things about terms of others");
  release->callback([=, &options] { ReleaseDocuments(command, *released, *editor, options); });
}

void PrintError(const std::exception& error) {
  const auto* fault = dynamic_cast<const Error*>(&error);
  std::string text = "lares: " + (fault != nullptr ? fault->FullMessage() : error.what()) + "\n";
  if (dynamic_cast<const http::NoServerError*>(&error) != nullptr) {
    text.back() = ';';
    text += " start one with: lares serve (or ./start)\n";
  }
  if (fault != nullptr && !fault->candidates().empty()) {
    text += "did you mean:";
    for (const std::string& candidate : fault->candidates()) text += "\n  " + candidate;
    text += "\n";
  }
  if (fault != nullptr && !fault->hint().empty()) text += "hint: " + fault->hint() + "\n";
  std::fputs(text.c_str(), stderr);
}

}  // namespace lares::cli
