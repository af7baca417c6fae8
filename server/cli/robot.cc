#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

std::string Metres(const Json& json, const char* name) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", json.value(name, 0.0));
  return text;
}

std::string Line(const std::string& what, const Json& because) {
  return "  " + what + "\n      " + TextOf(because, "reason") + "\n";
}

// "height at least " of what may be larger.
std::string AtLeast(const std::string& what, const Json& size) {
  return what + (size.value("is_lower_bound", false) ? " at least " : " ");
}

std::string LimbLines(const Json& import) {
  std::string text;
  const auto named = [](const Json& limb, const char* noun) {
    const std::string side = TextOf(limb, "side");
    return side.empty() ? std::string(noun) : side + " " + noun;
  };
  for (const Json& torso : import.at("torsos")) text += Line("torso", torso);
  for (const Json& head : import.at("heads")) text += Line("pan-tilt unit", head);
  for (const Json& arm : import.at("arms")) {
    text += Line(named(arm, "arm") + ", reach " + Metres(arm, "reach_m"), arm);
  }
  for (const Json& gripper : import.at("grippers"))
    text += Line(named(gripper, "gripper"), gripper);
  return text;
}

// What was concluded from a URDF, each conclusion with its reason.
std::string ImportText(const Json& answer) {
  if (!answer.contains("import")) return "";
  const Json& import = answer.at("import");
  std::string text = "  from URDF: " + Plural(import.value("links", std::size_t{0}), "link") +
                     ", " + Plural(import.value("joints", std::size_t{0}), "joint") +
                     ", seen from " + TextOf(import, "base_frame") + "\n";
  text += Line("base: " + TextOf(import.at("base"), "kind"), import.at("base"));
  if (import.contains("footprint")) {
    const Json& footprint = import.at("footprint");
    text += Line(AtLeast("footprint", footprint) + Metres(footprint, "length_m") + " x " +
                     Metres(footprint, "width_m") + ", radius " + Metres(footprint, "radius_m"),
                 footprint);
  }
  if (import.contains("height")) {
    const Json& height = import.at("height");
    text += Line(AtLeast("height", height) + Metres(height, "height_m"), height);
  }
  text += LimbLines(import);
  for (const Json& sensor : import.at("sensors")) {
    text += Line(TextOf(sensor, "kind") + " on " + TextOf(sensor, "link"), sensor);
  }
  for (const Json& stated : import.at("stated")) {
    text += "  " + TextOf(stated, "label") + ": as you state\n";
  }
  for (const Json& note : import.at("notes")) text += "  note: " + note.get<std::string>() + "\n";
  return text + FormatRemarks(import.at("findings"), "  the URDF:");
}

void MoreOptions(CLI::App& put, PutOptions& options) {
  const auto into = [&options](const char* name) {
    return [&options, name](const std::string& value) { options.query.emplace(name, value); };
  };
  put.add_option_function<std::vector<std::string>>(
         "--has",
         [&options](const std::vector<std::string>& names) {
           for (const std::string& name : names) options.query.emplace("has", name);
         },
         "URDF: a component that no URDF tells of, such as ObjectRecognitionComponent; repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  put.add_option_function<std::string>("--name", into("name"), "URDF: another name for people");
  put.add_option_function<std::string>("--base-frame", into("base_frame"),
                                       "URDF: the link that poses are seen from");
}

void GetAs(const std::string& id, const std::string& as, const std::string& out,
           const Options& options) {
  http::ClientRequest request;
  request.path = PathOf("/v1/robots", as == "urdf" ? std::vector<std::string>{id, "urdf"}
                                                   : std::vector<std::string>{id});
  if (as != "urdf") request.query.emplace("as", as);
  const std::string body = Remote(options.server).Send(request).body;
  if (out.empty()) return Print(body);
  WriteFileAtomically(out, body);
  Print("wrote " + out + " (" + FormatBytes(body.size()) + ")\n");
}

}  // namespace

void AddRobot(CLI::App& app, const Options& options) {
  auto* robot = AddCommand(app, "robot", "Robots: what they have and can",
                           "  lares robot put pr2.urdf --has NavigationComponent\n"
                           "  lares robot put pioneer.owl\n  lares robot list\n"
                           "  lares robot capabilities pr2\n  lares robot doctor pr2.urdf");
  robot->require_subcommand(1);
  DocumentCommand command{"/v1/robots", "robot", "NAMES", NamesOf};
  command.more_options = MoreOptions;
  command.more_summary = ImportText;
  command.files = "URDF or RDF (SRDL) files; the id is the file's stem";
  AddDocumentCommands(*robot, command, options, "pioneer.owl");
  auto* convert = AddCommand(*robot, "export", "The robot's SRDL in another format, or its URDF",
                             "  lares robot export pr2 --as rdf-xml --out pr2.owl\n"
                             "  lares robot export pr2 --as urdf");
  auto id = std::make_shared<std::string>();
  auto as = std::make_shared<std::string>("turtle");
  auto out = std::make_shared<std::string>();
  convert->add_option("ID", *id)->required();
  convert->add_option("--as", *as, "the format (default: turtle)")
      ->check(
          CLI::IsMember({"turtle", "rdf-xml", "n-triples", "n-quads", "trig", "json-ld", "urdf"}));
  convert->add_option("--out", *out, "file to write instead of standard output");
  convert->callback([=, &options] { GetAs(*id, *as, *out, options); });
  AddRobotQuestions(*robot, options);
  AddRobotPins(*robot, options);
}

}  // namespace lares::cli
