// Versions of environments compared, named, taken back and merged; robots pinned to one.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/environments";

// A version in a body: a number where it is one, else a tag.
Json VersionJson(const std::string& text) {
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return is_number && text.size() < 10 ? Json(std::stoi(text)) : Json(text);
}

struct By {
  std::string author, robot, mission, note;
};

void AddBy(CLI::App& command, By& by) {
  command.add_option("--author", by.author, "who does this");
  command.add_option("--robot", by.robot, "which robot");
  command.add_option("--mission", by.mission, "in which mission");
  command.add_option("--note", by.note, "why");
}

void PutBy(const By& by, Json& body) {
  const auto put = [&](const char* name, const std::string& text) {
    if (!text.empty()) body[name] = text;
  };
  put("author", by.author);
  put("robot", by.robot);
  put("mission", by.mission);
  put("note", by.note);
}

// --- Comparing --------------------------------------------------------------------------------

std::string NameOf(const Json& object) {
  const std::string label = TextOf(object, "label");
  return (label.empty() ? std::string(LocalName(TextOf(object, "iri"))) : label) + " (" +
         std::string(LocalName(TextOf(object, "class"))) + ")";
}

std::string Metres(const Json& value) {
  if (!value.is_number()) return "its pose came or went";
  char text[32];
  std::snprintf(text, sizeof text, "%.3g m", value.get<double>());
  return text;
}

std::string Degrees(const Json& value) {
  if (!value.is_number() || value.get<double>() < 0.0175) return "";
  char text[32];
  std::snprintf(text, sizeof text, ", turned %.1f°", value.get<double>() * 180 / M_PI);
  return text;
}

std::string ObjectLines(const Json& objects) {
  std::string text;
  for (const Json& object : objects.at("added")) text += "+ " + NameOf(object) + "\n";
  for (const Json& object : objects.at("gone")) text += "- " + NameOf(object) + "\n";
  for (const Json& moved : objects.at("moved")) {
    text += "~ " + NameOf(moved.at("after")) + " moved: " + Metres(moved.at("distance_m")) +
            Degrees(moved.at("angle_rad")) + "\n";
  }
  for (const Json& each : objects.at("reclassed")) {
    text += "~ " + NameOf(each.at("after")) + " was a " +
            std::string(LocalName(TextOf(each.at("before"), "class"))) + "\n";
  }
  for (const Json& each : objects.at("renamed")) {
    text += "~ " + NameOf(each.at("after")) + " was " + NameOf(each.at("before")) + ", " +
            Metres(each.at("distance_m")) + " away: likely the same\n";
  }
  return text;
}

std::string GridLine(const Json& grid) {
  if (!grid.is_object()) return "";
  char area[32];
  std::snprintf(area, sizeof area, "%.2f", grid.value("changed_area_m2", 0.0));
  const auto count = [&](const char* name) {
    return std::to_string(grid.value(name, std::uint64_t{0}));
  };
  return std::string("grid: ") + area + " m² changed (cells: " + count("became_occupied") +
         " became occupied, " + count("became_free") + " free, " + count("became_known") +
         " known, " + count("became_unknown") + " unknown, " + count("beyond_before") +
         " beyond it)\n";
}

std::string LayerLines(const Json& layers) {
  std::string text;
  for (const Json& layer : layers) {
    if (TextOf(layer, "change") == "same") continue;
    text += "layer " + TextOf(layer, "layer") + " " + TextOf(layer, "change");
    const bool both = layer.contains("bytes_before") && layer.contains("bytes_after");
    if (layer.contains("bytes_before")) {
      text += ": " + FormatBytes(layer.value("bytes_before", std::uint64_t{0}));
    }
    if (layer.contains("bytes_after")) {
      text += (both ? " → " : ": ") + FormatBytes(layer.value("bytes_after", std::uint64_t{0}));
    }
    text += "\n";
  }
  return text;
}

struct DiffOptions {
  std::string id, from, to;
};

void Diff(const DiffOptions& diff, const Options& options) {
  std::multimap<std::string, std::string> query;
  if (!diff.from.empty()) query.emplace("from", diff.from);
  if (!diff.to.empty()) query.emplace("to", diff.to);
  Remote remote(options.server);
  const Json answer = remote.GetJson(PathOf(kCollection, {diff.id, "diff"}), query);
  if (options.json) return PrintJson(answer);
  std::string text = ObjectLines(answer.at("objects")) + GridLine(answer.at("grid")) +
                     LayerLines(answer.at("layers"));
  if (text.empty()) text = "nothing changed\n";
  Print("environment " + diff.id + ", version " + std::to_string(answer.value("from", 0)) + " → " +
        std::to_string(answer.value("to", 0)) + "\n" + text);
}

void AddDiff(CLI::App& environment, const Options& options) {
  auto* command = AddCommand(environment, "diff", "What changed between two versions",
                             "  lares environment diff flat             the newest and its parent\n"
                             "  lares environment diff flat 3 tidy-flat");
  auto diff = std::make_shared<DiffOptions>();
  command->add_option("ID", diff->id)->required();
  command->add_option("FROM", diff->from, "a number or a tag; default: TO's parent");
  command->add_option("TO", diff->to, "default: the newest");
  command->callback([=, &options] { Diff(*diff, options); });
}

// --- Taking back and merging ------------------------------------------------------------------

void PrintVersion(const std::string& id, const Json& answer, const Options& options) {
  if (options.json) return PrintJson(answer);
  const Json& version = answer.at("version");
  Print("environment " + id + ", version " + std::to_string(version.value("number", 0)) +
        " (ETag " + TextOf(version, "etag") + ")\n" +
        FormatRemarks(answer.at("warnings"), "  warnings:"));
}

void AddRollBack(CLI::App& environment, const Options& options) {
  auto* command = AddCommand(environment, "rollback", "Make an older version the newest again",
                             "  lares environment rollback flat 3 --note 'the map was bent'");
  auto id = std::make_shared<std::string>();
  auto to = std::make_shared<std::string>();
  auto by = std::make_shared<By>();
  command->add_option("ID", *id)->required();
  command->add_option("VERSION", *to, "a number or a tag")->required();
  AddBy(*command, *by);
  command->callback([=, &options] {
    Json body{{"to", VersionJson(*to)}};
    PutBy(*by, body);
    PrintVersion(
        *id, Remote(options.server).SendJson("POST", PathOf(kCollection, {*id, "rollback"}), body),
        options);
  });
}

std::string ListOf(const Json& values) {
  if (values.is_null()) return "nothing";
  if (!values.is_array()) return TextOf(values, "sha256").substr(0, 12);
  std::vector<std::string> texts;
  for (const Json& value : values) texts.push_back(Shortened(value.get<std::string>(), 60));
  return texts.empty() ? "nothing" : Join(texts, ", ");
}

std::string ConflictLines(const Json& conflicts) {
  std::string text;
  for (const Json& conflict : conflicts) {
    if (!conflict.contains("subject")) {
      text += "layer " + TextOf(conflict, "layer") + " changed on both sides\n";
      continue;
    }
    const std::string property = TextOf(conflict, "property");
    text += "<" + TextOf(conflict, "subject") + "> ";
    if (property.empty()) {
      text += "was taken out on one side and changed on the other\n";
      continue;
    }
    text += std::string(LocalName(property)) + ": was " + ListOf(conflict.at("base")) +
            "\n    ours   " + ListOf(conflict.at("ours")) + "\n    theirs " +
            ListOf(conflict.at("theirs")) + "\n";
  }
  return text;
}

struct MergeOptions {
  std::string id, theirs, otherwise;
  std::vector<std::string> take;
  bool dry_run = false;
  By by;
};

Json MergeBody(const MergeOptions& merge) {
  Json body{{"theirs", VersionJson(merge.theirs)}, {"dry_run", merge.dry_run}};
  for (const std::string& each : merge.take) {
    const std::size_t equals = each.rfind('=');
    if (equals == std::string::npos || equals == 0) {
      throw CLI::ValidationError("--take", "'" + each + "' is not WHAT=ours or WHAT=theirs");
    }
    body["take"][each.substr(0, equals)] = each.substr(equals + 1);
  }
  if (!merge.otherwise.empty()) body["otherwise"] = merge.otherwise;
  PutBy(merge.by, body);
  return body;
}

void Merge(const MergeOptions& merge, const Options& options) {
  try {
    const Json answer =
        Remote(options.server)
            .SendJson("POST", PathOf(kCollection, {merge.id, "merge"}), MergeBody(merge));
    if (answer.contains("version")) return PrintVersion(merge.id, answer, options);
    if (options.json) return PrintJson(answer);
    const Json& conflicts = answer.at("conflicts");
    if (answer.value("up_to_date", false)) return Print("it is part of the newest already\n");
    Print(conflicts.empty() ? "no conflict\n" : ConflictLines(conflicts));
  } catch (const RemoteError& error) {
    const Json document = Json::parse(error.document(), nullptr, false);
    if (!options.json && document.is_object() && document.contains("conflicts")) {
      Print(ConflictLines(document.at("conflicts")));
    }
    throw;
  }
}

void AddMerge(CLI::App& environment, const Options& options) {
  auto* command =
      AddCommand(environment, "merge", "Bring another version, a branch, into the newest",
                 "  lares environment merge flat 5 --dry-run\n"
                 "  lares environment merge flat 5 --take grid=theirs --otherwise ours");
  auto merge = std::make_shared<MergeOptions>();
  command->add_option("ID", merge->id)->required();
  command->add_option("VERSION", merge->theirs, "a number or a tag")->required();
  command->add_option("--take", merge->take,
                      "LAYER=ours, LAYER=theirs, or an object's IRI instead of a layer; may be "
                      "repeated");
  command->add_option("--otherwise", merge->otherwise, "for every other conflict")
      ->check(CLI::IsMember({"ours", "theirs"}));
  command->add_flag("--dry-run", merge->dry_run, "only say what would conflict");
  AddBy(*command, merge->by);
  command->callback([=, &options] { Merge(*merge, options); });
}

// --- Tags and pins ----------------------------------------------------------------------------

struct TagOptions {
  std::string id, name, version, author, note;
  bool move = false, remove = false;
};

void ListTags(const TagOptions& tag, const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetJson(PathOf(kCollection, {tag.id, "tags"}));
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) return Print("no version of " + tag.id + " has a tag\n");
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    rows.push_back({TextOf(item, "name"), std::to_string(item.value("version", 0)),
                    FormatTime(TextOf(item, "created")), TextOf(item, "note")});
  }
  Print(FormatTable({"TAG", "VERSION", "MADE", "NOTE"}, rows));
}

void PutOrDeleteTag(const TagOptions& tag, const Options& options) {
  const std::string path = PathOf(kCollection, {tag.id, "tags", tag.name});
  if (tag.remove) {
    Remote(options.server).SendJson("DELETE", path, Json());
    return Print("tag " + tag.name + " removed\n");
  }
  Json body = Json::object();
  if (!tag.version.empty()) body["version"] = VersionJson(tag.version);
  if (tag.move) body["move"] = true;
  if (!tag.author.empty()) body["author"] = tag.author;
  if (!tag.note.empty()) body["note"] = tag.note;
  const Json answer = Remote(options.server).SendJson("PUT", path, body);
  if (options.json) return PrintJson(answer);
  Print(tag.name + " is version " + std::to_string(answer.value("version", 0)) + " of " + tag.id +
        "\n");
}

void AddTag(CLI::App& environment, const Options& options) {
  auto* command = AddCommand(environment, "tag", "Name a version, or list the names",
                             "  lares environment tag flat                  all tags\n"
                             "  lares environment tag flat before-party     the newest version\n"
                             "  lares environment tag flat stable 3 --move");
  auto tag = std::make_shared<TagOptions>();
  command->add_option("ID", tag->id)->required();
  command->add_option("NAME", tag->name);
  command->add_option("VERSION", tag->version, "default: the newest");
  command->add_flag("--move", tag->move, "also when the name stands for another version");
  command->add_flag("--delete", tag->remove, "take the name off");
  command->add_option("--author", tag->author, "who does this");
  command->add_option("--note", tag->note, "why");
  command->callback([=, &options] {
    return tag->name.empty() ? ListTags(*tag, options) : PutOrDeleteTag(*tag, options);
  });
}

}  // namespace

void AddEnvironmentVersions(CLI::App& environment, const Options& options) {
  AddDiff(environment, options);
  AddRollBack(environment, options);
  AddMerge(environment, options);
  AddTag(environment, options);
}

void AddRobotPins(CLI::App& robot, const Options& options) {
  auto* command = AddCommand(robot, "pin", "Keep a robot at one version of an environment",
                             "  lares robot pin amigo                 all its pins\n"
                             "  lares robot pin amigo flat 3\n"
                             "  lares robot pin amigo flat --delete");
  auto name = std::make_shared<std::string>();
  auto environment = std::make_shared<std::string>();
  auto version = std::make_shared<std::string>();
  auto remove = std::make_shared<bool>(false);
  command->add_option("ROBOT", *name)->required();
  command->add_option("ENVIRONMENT", *environment);
  command->add_option("VERSION", *version, "a number or a tag; default: the newest");
  command->add_flag("--delete", *remove, "let it use the newest version again");
  command->callback([=, &options] {
    if (environment->empty()) {
      Remote remote(options.server);
      const Json list = remote.GetJson(PathOf("/v1/robots", {*name, "pins"}));
      if (options.json) return PrintJson(list);
      std::vector<std::vector<std::string>> rows;
      for (const Json& item : list.at("items")) {
        rows.push_back({TextOf(item, "environment"), std::to_string(item.value("version", 0)),
                        FormatTime(TextOf(item, "created"))});
      }
      return Print(rows.empty() ? *name + " is pinned to nothing\n"
                                : FormatTable({"ENVIRONMENT", "VERSION", "SINCE"}, rows));
    }
    const std::string path = PathOf("/v1/robots", {*name, "pins", *environment});
    if (*remove) {
      Remote(options.server).SendJson("DELETE", path, Json());
      return Print(*name + " uses the newest version of " + *environment + " again\n");
    }
    Json body = Json::object();
    if (!version->empty()) body["version"] = VersionJson(*version);
    const Json answer = Remote(options.server).SendJson("PUT", path, body);
    if (options.json) return PrintJson(answer);
    Print(*name + " uses version " + std::to_string(answer.value("version", 0)) + " of " +
          *environment + "\n");
  });
}

}  // namespace lares::cli
