#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "mapping/environment/layer_format.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/environments.h"
#include "server/api/once.h"
#include "server/api/quarantine.h"
#include "server/api/uploads.h"
#include "server/http/etag.h"
#include "server/http/multipart.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

constexpr std::uint64_t kMaxUploadBytes = std::uint64_t{64} << 30;
constexpr std::size_t kMaxFieldBytes = 64 * 1024;

// Takes a form apart while it arrives: fields into the version, layers into blobs, each checked
// to be what it says before it is kept. A layer comes as its bytes or as a reference to an upload.
class VersionForm {
 public:
  VersionForm(store::Store& store, store::NewVersion& version) : store_(store), version_(version) {}

  http::MultipartHandler handler() {
    return {[this](const http::PartHeader& part) { Begin(part); },
            [this](std::string_view piece) { Data(piece); }, [this] { End(); }};
  }
  const std::map<std::string, environment::LayerFacts>& facts() const { return facts_; }

 private:
  void Begin(const http::PartHeader& part) {
    field_ = FieldOf(part.name);
    if (field_ != nullptr) {
      field_->clear();
      return;
    }
    if (!environment::IsLayerName(part.name)) Unknown(part.name);
    for (const store::LayerInfo& other : version_.layers) {
      if (other.name == part.name) {
        throw Error(Code::kInvalid, "layer '" + part.name + "' is there twice");
      }
    }
    layer_ = {part.name, part.file_name, "", {}, {}};
    if (part.content_type == kUploadReference) {
      is_reference_ = true;
      reference_.clear();
      field_ = &reference_;
      return;
    }
    writer_ = store_.NewBlob();
  }

  void Data(std::string_view piece) {
    if (writer_ != nullptr) {
      writer_->Append(piece);
      return;
    }
    if (field_->size() + piece.size() > kMaxFieldBytes) {
      throw Error(Code::kTooLarge, "a text field of the form is longer than 64 KiB");
    }
    field_->append(piece);
  }

  void End() {
    if (field_ == &parent_) version_.parent = ReadParent();
    if (field_ == &removed_) version_.removed_layers.push_back(std::exchange(removed_, ""));
    if (std::exchange(is_reference_, false)) return EndReference();
    if (writer_ == nullptr) return;
    writer_->Flush();
    CheckLayer(writer_->path());
    layer_.blob = writer_->Commit();
    writer_.reset();
    version_.layers.push_back(std::move(layer_));
  }

  void EndReference() {
    const auto claim = ClaimUpload(store_.uploads(), reference_);
    if (layer_.file_name.empty()) layer_.file_name = UploadFileName(claim->info());
    CheckLayer(claim->path());
    layer_.blob = claim->Adopt();
    version_.layers.push_back(std::move(layer_));
  }

  void CheckLayer(const std::filesystem::path& bytes) {
    if (layer_.file_name.empty()) layer_.file_name = layer_.name;
    environment::LayerFacts facts = environment::CheckLayer(layer_.name, bytes, layer_.file_name);
    layer_.media_type = facts.media_type;
    layer_.facts = facts.facts;
    facts_[layer_.name] = std::move(facts);
  }

  std::string* FieldOf(const std::string& name) {
    if (name == "type") return &version_.type_iri;
    if (name == "label") return &version_.label;
    if (name == "author") return &version_.author;
    if (name == "note") return &version_.note;
    if (name == "robot") return &version_.robot;
    if (name == "mission") return &version_.mission;
    if (name == "parent") return &parent_;
    if (name == "remove") return &removed_;
    return nullptr;
  }

  int ReadParent() const {
    int number = 0;
    const char* end = parent_.data() + parent_.size();
    const auto [stop, error] = std::from_chars(parent_.data(), end, number);
    if (error != std::errc() || stop != end || number < 1) {
      throw Error(Code::kInvalid, "the form's 'parent' is the number of a version, not '" +
                                      Shortened(parent_, 60) + "'");
    }
    return number;
  }

  [[noreturn]] static void Unknown(const std::string& name) {
    std::vector<std::string> known = environment::LayerNames();
    const std::string layers = Join(known, ", ");
    known.insert(known.end(),
                 {"type", "label", "author", "robot", "mission", "note", "parent", "remove"});
    throw Error(Code::kInvalid,
                "the form's part '" + name + "' is neither a layer (" + layers +
                    ") nor one of type, label, author, robot, mission, note, parent, remove")
        .WithCandidates(SimilarNames(name, known));
  }

  store::Store& store_;
  store::NewVersion& version_;
  std::map<std::string, environment::LayerFacts> facts_;
  std::string* field_ = nullptr;
  std::string removed_;
  std::string parent_;
  bool is_reference_ = false;
  std::string reference_;
  store::LayerInfo layer_;
  std::unique_ptr<store::BlobWriter> writer_;
};

// The condition, refused before the body is read when it cannot hold any more. The store decides
// again when it writes.
std::string EarlyCondition(const http::Request& request, const store::Store& store,
                           const std::string& id) {
  const auto existing = store.FindEnvironment(id);
  const std::optional<std::string> etag =
      existing ? std::optional(store.GetVersion(id, 0).etag()) : std::nullopt;
  const std::string condition = http::WriteCondition(request, etag);
  const bool holds = condition.empty() || (condition == "none" && !etag) ||
                     (condition == "*" && etag) || (etag && condition == *etag);
  if (!holds) {
    throw Error(Code::kPreconditionFailed,
                etag ? "'" + id + "' is at another version: its ETag is now " + *etag
                     : "there is no environment '" + id + "' yet");
  }
  return condition;
}

bool IsEmpty(const store::NewVersion& version) {
  return version.layers.empty() && version.removed_layers.empty() && version.type_iri.empty() &&
         version.label.empty() && version.author.empty() && version.robot.empty() &&
         version.mission.empty() && version.note.empty();
}

http::Response KeptAside(const server::Knowledge::VersionAnswer& answer) {
  Json json;
  json["document"] = ToJson(answer.aside);
  json["quarantined"] = answer.quarantined;
  AddRemarks(answer.remarks, answer.warnings, json);
  http::Response response = JsonAnswer(json, 202);
  response.headers.Set("Location", "/v1/quarantine/" + http::PercentEncode(answer.aside.id));
  return response;
}

http::Response PutVersionOf(const http::Request& request, const RequestMark& mark,
                            Context& context) {
  store::NewVersion version;
  version.environment = request.Param("id");
  if (!IsIdentifier(version.environment)) {
    throw Error(Code::kInvalid, "'" + version.environment +
                                    "' is no id: 1 to 128 of A-Z a-z 0-9 "
                                    ". _ -, the first not . or -");
  }
  version.if_match = EarlyCondition(request, context.store, version.environment);
  VersionForm form(context.store, version);
  http::ReadMultipart(request, form.handler());
  version.request_key = mark.key;
  version.request_fingerprint = mark.fingerprint();
  if (IsEmpty(version)) {
    throw Error(Code::kInvalid,
                "there is nothing to put: the form has neither a layer nor a field");
  }
  if (!version.type_iri.empty()) {
    version.type_iri = context.knowledge.ResolveClass(version.type_iri).iri;
  }
  server::Knowledge::VersionAnswer answer =
      PutVersion(context, version, ReadVersionRights(request));
  for (std::string& warning : environment::WarnOnExtents(form.facts())) {
    answer.warnings.push_back(std::move(warning));
  }
  return answer.quarantined.empty() ? VersionCreated(answer) : KeptAside(answer);
}

// The answer for a version ("lab/3") that was written by a process which ended before it answered.
http::Response VersionWritten(const std::string& written, Context& context) {
  const std::size_t slash = written.rfind('/');
  server::Knowledge::VersionAnswer answer;
  answer.version =
      context.store.GetVersion(written.substr(0, slash), std::stoi(written.substr(slash + 1)));
  const auto& changed = answer.version.changed_layers;
  if (std::find(changed.begin(), changed.end(), "semantic") != changed.end()) {
    answer.objects =
        context.knowledge.MapObjects(answer.version.environment, answer.version.number);
  }
  return VersionCreated(answer);
}

}  // namespace

http::Response VersionCreated(const server::Knowledge::VersionAnswer& answer) {
  Json json;
  json["version"] = ToJson(answer.version);
  AddRemarks(answer.remarks, answer.warnings, json);
  json["objects"] = answer.objects.size();
  http::Response response = JsonAnswer(json, 201);
  response.headers.Set("ETag", answer.version.etag());
  response.headers.Set("Location", "/v1/environments/" +
                                       http::PercentEncode(answer.version.environment) +
                                       "/versions/" + std::to_string(answer.version.number));
  return response;
}

void AddEnvironmentUploadRoute(http::Router& router, Context& context) {
  router.Add({"POST",
              "/v1/environments/{id}/versions",
              "putEnvironmentVersion",
              Once(context, {[&context](const http::Request& request, const RequestMark& mark) {
                               return PutVersionOf(request, mark, context);
                             },
                             [&context](const std::string& written) {
                               return VersionWritten(written, context);
                             }}),
              {"multipart/form-data"},
              kMaxUploadBytes});
}

}  // namespace lares::api
