#include "server/knowledge/versions.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "mapping/environment/tar_reader.h"
#include "mapping/grid/read_grid.h"
#include "ontology/rdf/writer.h"

namespace lares::server {
namespace {

using Layers = std::map<std::string, store::LayerInfo>;

constexpr const char* kSemantic = "semantic";
constexpr const char* kMergedFile = "merged.ttl";

Layers LayersOf(const store::EnvironmentVersion& version) {
  Layers layers;
  for (const store::LayerInfo& layer : version.layers) layers[layer.name] = layer;
  return layers;
}

std::set<std::string> NamesOf(const std::vector<const Layers*>& all) {
  std::set<std::string> names;
  for (const Layers* layers : all) {
    for (const auto& [name, layer] : *layers) names.insert(name);
  }
  return names;
}

const store::LayerInfo* Find(const Layers& layers, const std::string& name) {
  const auto found = layers.find(name);
  return found == layers.end() ? nullptr : &found->second;
}

bool IsByEditor(const store::EnvironmentVersion& version) {
  return std::any_of(version.layers.begin(), version.layers.end(),
                     [](const auto& layer) { return layer.facts.count("editor") > 0; });
}

std::optional<store::Blob> BlobOf(const store::LayerInfo* layer) {
  return layer == nullptr ? std::nullopt : std::optional(layer->blob);
}

bool Same(const store::LayerInfo* a, const store::LayerInfo* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->blob.sha256 == b->blob.sha256;
}

LayerDiff Compare(const std::string& name, const store::LayerInfo* before,
                  const store::LayerInfo* after) {
  LayerDiff diff{name, LayerDiff::Kind::kChanged, BlobOf(before), BlobOf(after)};
  if (before == nullptr) diff.kind = LayerDiff::Kind::kAdded;
  if (after == nullptr) diff.kind = LayerDiff::Kind::kRemoved;
  if (Same(before, after)) diff.kind = LayerDiff::Kind::kSame;
  return diff;
}

grid::Grid ReadGridOf(const store::Store& store, const store::LayerInfo& layer) {
  const std::filesystem::path path = store.BlobPath(layer.blob.sha256);
  return grid::ReadGrid([&] { return environment::TarReader::OfFile(path, layer.file_name); },
                        layer.file_name);
}

void CompareGrids(const store::Store& store, const Layers& before, const Layers& after,
                  VersionDiff& diff) {
  const store::LayerInfo* stood = Find(before, "grid");
  const store::LayerInfo* stands = Find(after, "grid");
  if (stood == nullptr || stands == nullptr || Same(stood, stands)) return;
  try {
    diff.grid = grid::DiffGrids(ReadGridOf(store, *stood), ReadGridOf(store, *stands));
  } catch (const Error& error) {
    diff.grid_problem = error.what();
  }
}

const store::EnvironmentVersion* FindIn(const std::vector<store::EnvironmentVersion>& log,
                                        int number) {
  const auto found = std::find_if(log.begin(), log.end(),
                                  [&](const auto& version) { return version.number == number; });
  return found == log.end() ? nullptr : &*found;
}

// `number` and all that it comes from.
std::set<int> LineOf(const std::vector<store::EnvironmentVersion>& log, int number) {
  std::set<int> line;
  std::vector<int> open{number};
  while (!open.empty()) {
    const int next = open.back();
    open.pop_back();
    const store::EnvironmentVersion* version = FindIn(log, next);
    if (version == nullptr || !line.insert(next).second) continue;
    open.insert(open.end(), version->parents.begin(), version->parents.end());
  }
  return line;
}

store::NewVersion Made(const std::string& environment, const VersionBy& by) {
  store::NewVersion version;
  version.environment = environment;
  version.author = by.author;
  version.robot = by.robot;
  version.mission = by.mission;
  version.note = by.note;
  version.if_match = by.if_match;
  return version;
}

// Decides layer by layer, then what the semantic one says.
class Merge {
 public:
  Merge(Knowledge& knowledge, const MergeRequest& request, MergeAnswer& answer)
      : knowledge_(knowledge), request_(request), answer_(answer) {}

  // What is to be put over `ours`.
  store::NewVersion Make(const store::EnvironmentVersion& base,
                         const store::EnvironmentVersion& ours,
                         const store::EnvironmentVersion& theirs) {
    store::NewVersion version = Made(request_.environment, request_.by);
    version.parent = ours.number;
    version.merged = theirs.number;
    if (ours.type_iri == base.type_iri) version.type_iri = theirs.type_iri;
    if (ours.label == base.label) version.label = theirs.label;
    const Layers b = LayersOf(base);
    const Layers o = LayersOf(ours);
    const Layers t = LayersOf(theirs);
    for (const std::string& name : NamesOf({&b, &o, &t})) {
      MergeLayer(name, Find(b, name), Find(o, name), Find(t, name), version);
    }
    return version;
  }

 private:
  void MergeLayer(const std::string& name, const store::LayerInfo* base,
                  const store::LayerInfo* ours, const store::LayerInfo* theirs,
                  store::NewVersion& version) {
    if (Same(ours, theirs) || Same(base, theirs)) return;
    if (Same(base, ours)) return TakeTheirs(name, theirs, version);
    const std::optional<rdf::Side> side = Choice(name);
    if (!side && name == kSemantic && base != nullptr && ours != nullptr && theirs != nullptr) {
      return MergeSemantic(*base, *ours, *theirs, version);
    }
    const std::optional<rdf::Side> chosen = side ? side : request_.otherwise;
    if (!chosen) {
      answer_.layer_conflicts.push_back({name, BlobOf(base), BlobOf(ours), BlobOf(theirs)});
    } else if (*chosen == rdf::Side::kTheirs) {
      TakeTheirs(name, theirs, version);
    }
  }

  static void TakeTheirs(const std::string& name, const store::LayerInfo* theirs,
                         store::NewVersion& version) {
    if (theirs != nullptr) {
      version.layers.push_back(*theirs);
    } else {
      version.removed_layers.push_back(name);
    }
  }

  void MergeSemantic(const store::LayerInfo& base, const store::LayerInfo& ours,
                     const store::LayerInfo& theirs, store::NewVersion& version) {
    rdf::MergeResult merged =
        rdf::MergeThreeWays(Read(base), Read(ours), Read(theirs),
                            [this](const rdf::MergeConflict& conflict) -> std::optional<rdf::Side> {
                              const std::optional<rdf::Side> side = Choice(conflict.subject);
                              return side ? side : request_.otherwise;
                            });
    if (!merged.conflicts.empty()) {
      answer_.conflicts = std::move(merged.conflicts);
      return;
    }
    if (request_.dry_run) return;
    const std::unique_ptr<store::BlobWriter> writer = knowledge_.store().NewBlob();
    writer->Append(rdf::WriteRdf(merged.document, rdf::Format::kTurtle));
    store::LayerInfo layer;
    layer.name = kSemantic;
    layer.file_name = kMergedFile;
    layer.media_type = rdf::MediaType(rdf::Format::kTurtle);
    layer.facts = ours.facts;
    layer.blob = writer->Commit();
    version.layers.push_back(std::move(layer));
  }

  rdf::Document Read(const store::LayerInfo& layer) {
    return knowledge_.ReadSemantic(request_.environment, layer);
  }

  std::optional<rdf::Side> Choice(const std::string& name) const {
    const auto found = request_.take.find(name);
    return found == request_.take.end() ? std::nullopt : std::optional(found->second);
  }

  Knowledge& knowledge_;
  const MergeRequest& request_;
  MergeAnswer& answer_;
};

}  // namespace

VersionDiff DiffVersions(Knowledge& knowledge, const std::string& environment, int before,
                         int after, const semantic::DiffTolerance& tolerance) {
  const store::Store& store = knowledge.store();
  VersionDiff diff;
  diff.before = store.GetVersion(environment, before);
  diff.after = store.GetVersion(environment, after);
  const Layers stood = LayersOf(diff.before);
  const Layers stands = LayersOf(diff.after);
  for (const std::string& name : NamesOf({&stood, &stands})) {
    diff.layers.push_back(Compare(name, Find(stood, name), Find(stands, name)));
  }
  diff.objects =
      semantic::DiffObjects(knowledge.MapObjects(environment, diff.before.number),
                            knowledge.MapObjects(environment, diff.after.number), tolerance);
  CompareGrids(store, stood, stands, diff);
  return diff;
}

Knowledge::VersionAnswer RollBack(Knowledge& knowledge, const std::string& environment, int to,
                                  const VersionBy& by) {
  store::NewVersion version = Made(environment, by);
  version.restored = knowledge.store().GetVersion(environment, to).number;
  if (version.note.empty()) version.note = "back to version " + std::to_string(version.restored);
  return knowledge.PutVersion(version);
}

int NearestCommonVersion(const std::vector<store::EnvironmentVersion>& log, int a, int b) {
  const std::set<int> line_a = LineOf(log, a);
  const std::set<int> line_b = LineOf(log, b);
  for (auto it = line_a.rbegin(); it != line_a.rend(); ++it) {
    if (line_b.count(*it) > 0) return *it;
  }
  return 0;
}

MergeAnswer MergeVersions(Knowledge& knowledge, const MergeRequest& request) {
  const store::Store& store = knowledge.store();
  const std::vector<store::EnvironmentVersion> log = store.Log(request.environment);
  const store::EnvironmentVersion ours = store.GetVersion(request.environment, request.ours);
  const store::EnvironmentVersion theirs = store.GetVersion(request.environment, request.theirs);
  const store::EnvironmentVersion head = store.GetVersion(request.environment, 0);
  if (ours.number != head.number) {
    throw Error(Code::kInvalid, "version " + std::to_string(ours.number) +
                                    " is not the newest of '" + request.environment +
                                    "': another one is merged into version " +
                                    std::to_string(head.number) + " only");
  }
  MergeAnswer answer;
  answer.ours = ours.number;
  answer.theirs = theirs.number;
  answer.base = NearestCommonVersion(log, ours.number, theirs.number);
  answer.up_to_date = answer.base == theirs.number;
  if (answer.up_to_date) return answer;
  store::EnvironmentVersion base;
  if (answer.base != 0) base = store.GetVersion(request.environment, answer.base);
  store::NewVersion version = Merge(knowledge, request, answer).Make(base, ours, theirs);
  if (!answer.conflicts.empty() || !answer.layer_conflicts.empty() || request.dry_run) {
    return answer;
  }
  if (version.note.empty()) {
    version.note = "version " + std::to_string(theirs.number) + " merged";
  }
  if (version.if_match.empty()) version.if_match = ours.etag();
  // What is merged was taken before, by those who had the right.
  answer.merged = knowledge.PutVersion(version, {IsByEditor(ours) || IsByEditor(theirs), false});
  return answer;
}

}  // namespace lares::server
