#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number.h"
#include "server/api/answers.h"
#include "server/api/object_models.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

using server::ObjectModelInfo;

std::string LinkTo(const std::string& id) { return "/v1/object-models/" + http::PercentEncode(id); }

Json ExtentsToJson(const objects::Extents& extents) {
  Json json;
  const std::array<const char*, 3> names =
      extents.axes_known ? std::array<const char*, 3>{"width_m", "height_m", "depth_m"}
                         : std::array<const char*, 3>{"x_m", "y_m", "z_m"};
  for (std::size_t i = 0; i < 3; ++i) json[names[i]] = extents.size_m[i];
  json["from"] = extents.from;
  return json;
}

Json AlgorithmsToJson(const std::vector<ObjectModelInfo::Algorithm>& algorithms) {
  Json list = Json::array();
  for (const auto& algorithm : algorithms) list.push_back(ToJson(algorithm.what));
  return list;
}

const char* ToString(ObjectModelInfo::Fit fit) {
  switch (fit) {
    case ObjectModelInfo::Fit::kSame:
      return "same";
    case ObjectModelInfo::Fit::kKindOf:
      return "kind-of";
    case ObjectModelInfo::Fit::kMoreGeneral:
      return "more-general";
    default:
      return "any";
  }
}

// What is known of it, without its document.
Json KnownOf(const ObjectModelInfo& info) {
  Json json{{"classes", ToJson(info.classes)},
            {"kinds", ToJson(info.kinds)},
            {"algorithms", AlgorithmsToJson(info.algorithms)},
            {"makers", ToJson(info.makers)},
            {"created", info.created.empty() ? Json() : Json(info.created)},
            {"extents", info.extents ? ExtentsToJson(*info.extents) : Json()},
            {"size_bytes", info.size_bytes}};
  return json;
}

// The description first, then the files; "link" leads to the bytes.
Json FilesToJson(const ObjectModelInfo& info) {
  const store::DocumentInfo& document = info.document;
  const std::string link = LinkTo(document.id);
  Json files = Json::array();
  files.push_back({{"file_name", document.file_name.empty() ? document.id : document.file_name},
                   {"media_type", document.media_type},
                   {"size", document.blob.size},
                   {"sha256", document.blob.sha256},
                   {"link", link + "?version=" + std::to_string(document.version)}});
  for (const server::PackageFile& file : info.files) {
    files.push_back({{"file_name", file.file_name},
                     {"media_type", file.media_type},
                     {"size", file.blob.size},
                     {"sha256", file.blob.sha256},
                     {"link", link + "/files/" + http::PercentEncode(file.file_name)}});
  }
  return files;
}

Json ToJson(const server::TypicalAnswer::Model& model) {
  const models::Choice& choice = model.choice;
  Json json{{"id", model.info.document.id},
            {"version", model.info.document.version},
            {"verdict", models::ToString(choice.verdict)},
            {"why", choice.why},
            {"class", api::ToJson(model.of)},
            {"probability", choice.probability},
            {"probability_of_room", choice.probability_of_room},
            {"counted", choice.counted},
            {"counted_above", choice.counted_above},
            {"nth_of_its_class", choice.nth_of_its_class},
            {"robot_has", choice.robot_has ? Json(*choice.robot_has) : Json()}};
  json.update(KnownOf(model.info));
  json["files"] = FilesToJson(model.info);
  return json;
}

Json ToJson(const server::TypicalAnswer& answer) {
  Json json{{"room", api::ToJson(answer.room)},
            {"robot", answer.robot ? api::ToJson(*answer.robot) : Json()},
            {"prior", {{"name", answer.prior}, {"title", answer.prior_title}}},
            {"places", api::ToJson(answer.places)},
            {"places_above", answer.places_above},
            {"size_bytes", answer.size_bytes},
            {"loaded", Json::array()},
            {"left_out", Json::array()}};
  for (const auto& model : answer.loaded) json["loaded"].push_back(ToJson(model));
  for (const auto& model : answer.left_out) json["left_out"].push_back(ToJson(model));
  return json;
}

std::optional<std::uint64_t> QueryCount(const http::Request& request, const std::string& name) {
  const auto value = request.Query(name);
  if (!value) return std::nullopt;
  std::uint64_t number = 0;
  const char* end = value->data() + value->size();
  const auto read = std::from_chars(value->data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) {
    throw Error(Code::kInvalid, "?" + name + "= is a whole number, not '" + *value + "'");
  }
  return number;
}

std::optional<double> QueryProbability(const http::Request& request, const std::string& name) {
  const auto value = request.Query(name);
  if (!value) return std::nullopt;
  const auto number = ToNumber(*value);
  if (!number || !(*number >= 0 && *number <= 1)) {
    throw Error(Code::kInvalid, "?" + name + "= is a number from 0 to 1, not '" + *value + "'");
  }
  return number;
}

}  // namespace

http::Response ListObjectModels(const http::Request& request, Context& context) {
  const auto text = [&](const char* name) { return request.Query(name).value_or(""); };
  const std::vector<ObjectModelInfo> found = context.knowledge.ObjectModels(
      {text("class"), text("room"), text("maker"), text("algorithm"), text("kind")});
  return Page(
      request, found.size(), [&](std::size_t i) { return found[i].document.id; },
      [&](std::size_t i) {
        Json json = api::ToJson(found[i].document);
        json.update(KnownOf(found[i]));
        if (found[i].fit != ObjectModelInfo::Fit::kAny) json["fit"] = ToString(found[i].fit);
        if (found[i].probability) {
          json["probability"] = *found[i].probability;
          json["why"] = found[i].why;
        }
        return json;
      });
}

http::Response TypicalObjectModels(const http::Request& request, Context& context) {
  server::TypicalRequest typical;
  typical.room = request.Query("room").value_or("");
  if (typical.room.empty()) throw Error(Code::kInvalid, "?room= is missing");
  typical.robot = request.Query("robot").value_or("");
  typical.prior = request.Query("prior").value_or("");
  typical.strict = QueryFlag(request, "strict");
  typical.min_probability = QueryProbability(request, "min_probability");
  typical.max_models = QueryCount(request, "max_models");
  typical.max_bytes = QueryCount(request, "max_bytes");
  return JsonAnswer(ToJson(context.knowledge.TypicalModels(typical)));
}

}  // namespace lares::api
