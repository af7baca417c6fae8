#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"
#include "server/http/media_type.h"

namespace lares::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> files;
  bool recover = false;
};

Json CheckFile(Remote& remote, const std::filesystem::path& file, bool recover) {
  http::ClientRequest request;
  request.method = "POST";
  request.path = "/v1/ontology/check";
  request.query.emplace("file_name", file.filename().string());
  if (recover) request.query.emplace("recover", "true");
  request.headers.Set("Content-Type", http::MediaTypeOfFile(file.filename().string()));
  request.body = ReadLocalFile(file, 256u << 20);
  return Json::parse(remote.Send(request).body);
}

std::string PlaceText(const std::string& file, const Json& place) {
  return ToString(Place{file, place.value("line", 0), place.value("column", 0)});
}

// "core.ttl:12:3: profile: … (Cup, Mug and 5 more; 7 places, also 18:3, 25:3)"
std::string FindingText(const std::string& file, const Json& finding) {
  const Json& places = finding.at("places");
  const auto count = finding.value("count", std::size_t{1});
  std::string text = (places.empty() ? file : PlaceText(file, places[0])) + ": " +
                     TextOf(finding, "kind") + ": " + TextOf(finding, "message") + " (";
  const std::vector<std::string> names = finding.at("names");
  text += Join(names, ", ");
  if (count > names.size() && names.size() >= 5) text += ", …";
  if (count > 1) text += "; " + std::to_string(count) + " places";
  std::vector<std::string> others;
  for (std::size_t i = 1; i < places.size(); ++i) {
    others.push_back(PlaceText("", places[i]));
    if (others.back().starts_with(':')) others.back().erase(0, 1);
  }
  if (!others.empty()) text += ", also " + Join(others, ", ");
  return text + ")\n";
}

std::string CheckText(const std::string& file, const Json& answer) {
  std::string text;
  for (const char* list : {"repairs", "warnings"}) {
    for (const Json& remark : answer.value(list, Json::array())) {
      text += PlaceText(file, remark.value("place", Json::object())) +
              ": remark: " + TextOf(remark, "message") + "\n";
    }
  }
  for (const Json& finding : answer.at("findings")) text += FindingText(file, finding);
  const bool is_rl = answer.value("owl2_rl", false);
  return text + file + ": " + std::to_string(answer.value("statements", std::size_t{0})) +
         " statements, " + (is_rl ? "OWL 2 RL" : "not OWL 2 RL") +
         (answer.value("clean", false) ? ", clean\n" : "\n");
}

void Check(const CheckOptions& check, const Options& options) {
  Remote remote(options.server);
  Json answers = Json::array();
  std::exception_ptr fault;
  std::size_t unclean = 0;
  for (const std::string& file : check.files) {
    try {
      Json answer = CheckFile(remote, file, check.recover);
      if (!answer.value("clean", false)) ++unclean;
      if (!options.json) Print(CheckText(file, answer));
      answers.push_back(std::move(answer));
    } catch (const RemoteError& error) {
      if (check.files.size() == 1) throw;
      PrintError(error);
      fault = std::current_exception();
    }
  }
  if (options.json) PrintJson(check.files.size() == 1 ? answers.front() : answers);
  if (fault) std::rethrow_exception(fault);
  if (unclean == 0) return;
  throw FindingsError(check.files.size() == 1
                          ? check.files.front() + " is not clean"
                          : std::to_string(unclean) + " of " + Plural(check.files.size(), "file") +
                                " are not clean");
}

}  // namespace

void AddOntologyCheck(CLI::App& ontology, const Options& options) {
  auto* command =
      AddCommand(ontology, "check", "What is wrong with ontology documents; nothing is kept",
                 "  lares ontology check kitchen.ttl\n  lares ontology check --json kitchen.ttl\n"
                 "Exit code 0: nothing but remarks was found; 9: something was.");
  auto check = std::make_shared<CheckOptions>();
  command->add_option("FILE", check->files)->required();
  command->add_flag("--recover", check->recover, "repair the known faults of RDF/XML first");
  command->callback([check, &options] { Check(*check, options); });
}

}  // namespace lares::cli
