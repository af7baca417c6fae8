#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/robots";

// What is missing at the ends of the branches of a finding.
void AddMissing(const Json& finding, std::vector<std::string>& missing) {
  const Json dependencies = finding.value("dependencies", Json::array());
  bool deeper = false;
  for (const Json& dependency : dependencies) {
    if (TextOf(dependency, "availability") == "available") continue;
    deeper = true;
    AddMissing(dependency, missing);
  }
  const std::string label = TextOf(finding.at("what"), "label");
  const bool is_component = TextOf(finding, "kind") == "component";
  if (deeper && !is_component) return;
  if (std::find(missing.begin(), missing.end(), label) == missing.end()) missing.push_back(label);
}

void ShowCapabilities(const std::string& id, bool strict, bool all, const Options& options) {
  std::multimap<std::string, std::string> query;
  if (strict) query.emplace("strict", "true");
  const Json answer =
      Remote(options.server).GetJson(PathOf(kCollection, {id, "capabilities"}), query);
  if (options.json) return PrintJson(answer);
  std::string there, missing;
  std::size_t missing_count = 0;
  for (const Json& finding : answer.at("capabilities")) {
    const std::string availability = TextOf(finding, "availability");
    const std::string line = "  " + TextOf(finding.at("what"), "label") + "\n      " +
                             TextOf(finding, "explanation") + "\n";
    if (availability == "available" || availability == "on-makers-word") {
      there += line;
      continue;
    }
    ++missing_count;
    if (!all && finding.value("dependencies", Json::array()).empty()) continue;
    missing += line;
    std::vector<std::string> leaves;
    AddMissing(finding, leaves);
    for (const std::string& leaf : leaves) missing += "        lacks " + leaf + "\n";
  }
  Print(TextOf(answer.at("robot"), "label") + " can:\n" +
        (there.empty() ? "  nothing that is known\n" : there) + "It cannot, for now (" +
        std::to_string(missing_count) + "):\n" + missing);
}

void DrawTree(const std::string& id, const std::string& out, const std::string& as,
              const Options& options) {
  http::ClientRequest request;
  request.path = PathOf(kCollection, {id, "tree"});
  const bool is_dot = as == "dot" || (as.empty() && out.ends_with(".dot"));
  if (is_dot) request.query.emplace("as", "dot");
  const std::string picture = Remote(options.server).Send(request).body;
  if (out.empty()) return Print(picture);
  WriteFileAtomically(out, picture);
  Print("wrote " + out + " (" + FormatBytes(picture.size()) + ")\n");
}

std::string FindingText(const Json& finding, const std::string& source) {
  std::string text = "  " + TextOf(finding, "severity") + " ";
  text += finding.contains("place")
              ? source + ":" + std::to_string(finding.at("place").value("line", 0)) + ": "
              : "";
  text += TextOf(finding, "message") + " [" + TextOf(finding, "code") + "]\n";
  const std::string remedy = TextOf(finding, "remedy");
  return remedy.empty() ? text : text + "      " + remedy + "\n";
}

void Examine(const std::string& what, const std::string& srdl, const Options& options) {
  http::ClientRequest request;
  const std::filesystem::path file(what);
  if (std::filesystem::is_regular_file(file)) {
    request.method = "POST";
    request.path = PathOf(kCollection, {"doctor"});
    request.query.emplace("file_name", file.filename().string());
    request.headers.Set("Content-Type", "application/urdf+xml");
    request.body = ReadLocalFile(file, 64u << 20);
  } else {
    request.path = PathOf(kCollection, {what, "doctor"});
  }
  if (!srdl.empty()) request.query.emplace("srdl", srdl);
  const Json answer = Json::parse(Remote(options.server).Send(request).body);
  const auto errors = answer.value("errors", std::size_t{0});
  const auto warnings = answer.value("warnings", std::size_t{0});
  if (options.json) {
    PrintJson(answer);
  } else {
    std::string text = TextOf(answer, "source") + ": " + Plural(errors, "error") + ", " +
                       Plural(warnings, "warning") + ", " +
                       Plural(answer.value("notes", std::size_t{0}), "note") + "\n";
    for (const Json& finding : answer.at("findings")) {
      text += FindingText(finding, TextOf(answer, "source"));
    }
    Print(text);
  }
  if (errors > 0) throw FindingsError("the URDF has " + Plural(errors, "error"));
}

}  // namespace

void AddRobotQuestions(CLI::App& robot, const Options& options) {
  auto* can =
      AddCommand(robot, "capabilities", "What a robot can do, and what keeps it from the rest",
                 "  lares robot capabilities pr2\n"
                 "  lares robot capabilities pr2 --strict --json");
  auto id = std::make_shared<std::string>();
  auto strict = std::make_shared<bool>(false);
  auto all = std::make_shared<bool>(false);
  can->add_option("ID", *id, "one of the robot's names")->required();
  can->add_flag("--strict", *strict, "what is there on the maker's word only counts as missing");
  can->add_flag("--all", *all, "also capabilities of which nothing is known but their name");
  can->callback([=, &options] { ShowCapabilities(*id, *strict, *all, options); });

  auto* tree = AddCommand(robot, "tree", "A robot's kinematic tree as a picture",
                          "  lares robot tree pr2 --out tree.svg\n  lares robot tree pr2 --as dot");
  auto of = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto as = std::make_shared<std::string>();
  tree->add_option("ID", *of)->required();
  tree->add_option("--out", *out, "file to write instead of standard output");
  tree->add_option("--as", *as, "svg or dot (default: by the file's name, else svg)")
      ->check(CLI::IsMember({"svg", "dot"}));
  tree->callback([=, &options] { DrawTree(*of, *out, *as, options); });

  auto* doctor = AddCommand(robot, "doctor", "What is wrong with a URDF, and what to do about it",
                            "  lares robot doctor my-robot.urdf\n  lares robot doctor pr2\n"
                            "  lares robot doctor pr2.urdf --srdl pr2 --json");
  auto what = std::make_shared<std::string>();
  auto srdl = std::make_shared<std::string>();
  doctor->add_option("FILE|ID", *what, "a URDF, or a robot that was put as one")->required();
  doctor->add_option("--srdl", *srdl, "compare with this stored robot's SRDL");
  doctor->callback([=, &options] { Examine(*what, *srdl, options); });
}

}  // namespace lares::cli
