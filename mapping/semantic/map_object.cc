#include "mapping/semantic/map_object.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "mapping/semantic/frames.h"
#include "mapping/semantic/most_specific_class.h"
#include "mapping/semantic/names.h"
#include "mapping/semantic/parts.h"
#include "mapping/semantic/values.h"

namespace lares::semantic {
namespace {

// An event that perceived an object.
struct Perception {
  rdf::TermId event{};
  std::optional<Time> time;
  std::optional<rdf::TermId> matrix;
};

// What the map holds of one object, before it is interpreted.
struct Mention {
  std::vector<rdf::TermId> entries;  // MapObjects that stand for it
  std::vector<Perception> perceptions;
  std::optional<rdf::TermId> matrix;  // that of the latest perception, or its own
  std::vector<std::string> remarks;
};

using Mentions = std::map<rdf::TermId, Mention>;

[[noreturn]] void Fail(const rdf::View& view, rdf::TermId object, const std::string& message) {
  throw Error(Code::kInvalid, Quoted(view, object) + ": " + message);
}

// Visits every triple of the top layer with `predicate`, asserted (also where a layer below holds
// the same) or inferred; some twice.
template <typename Visit>
void ForEachOnTop(const rdf::View& view, rdf::TermId predicate, const Visit& visit) {
  const rdf::Layer& top = *view.layers().back();
  for (const rdf::Triple& triple : top.Range({rdf::kAnyTerm, predicate, rdf::kAnyTerm})) {
    visit(triple);
  }
  for (const rdf::Graph& graph : top.graphs()) {
    for (const rdf::Triple& triple : graph.triples) {
      if (triple.predicate == predicate) visit(triple);
    }
  }
}

class Collector {
 public:
  Collector(const rdf::View& view, const Names& names) : view_(view), names_(names) {}

  Mentions Run() {
    CollectPerceived();
    ForEachOnTop(view_, names_.described_in_map, [&](const rdf::Triple& t) { Add(t.subject); });
    ForEachOnTop(view_, names_.orientation, [&](const rdf::Triple& t) { Add(t.subject); });
    ForEachOnTop(view_, names_.type, [&](const rdf::Triple& t) {
      if (t.object == names_.map_object) AddEntry(t.subject);
    });
    CollectParts();
    return std::move(mentions_);
  }

 private:
  bool Is(rdf::TermId term, rdf::TermId type) const {
    return view_.Contains({term, names_.type, type});
  }

  bool CanBeObject(rdf::TermId term) const {
    return view_.dictionary().Get(term).kind != rdf::TermKind::kLiteral &&
           !Is(term, names_.semantic_environment_map) && !Is(term, names_.map) &&
           !Is(term, names_.rotation_matrix) && !Is(term, names_.owl_class);
  }

  Mention* Add(rdf::TermId term) { return CanBeObject(term) ? &mentions_[term] : nullptr; }

  void CollectPerceived() {
    std::set<rdf::Triple> seen;
    ForEachOnTop(view_, names_.object_acted_on, [&](const rdf::Triple& triple) {
      const bool is_perception = Is(triple.subject, names_.semantic_map_perception) ||
                                 Is(triple.subject, names_.visual_perception);
      if (!is_perception || !seen.insert(triple).second) return;
      if (Mention* mention = Add(triple.object)) AddPerception(triple.subject, *mention);
    });
  }

  // The parts of what is an object, and their parts.
  void CollectParts() {
    std::map<rdf::TermId, std::vector<rdf::TermId>> parts;
    ForEachOnTop(view_, names_.proper_parts,
                 [&](const rdf::Triple& t) { parts[t.subject].push_back(t.object); });
    const Parts places(view_, names_);
    std::vector<rdf::TermId> open;
    for (const auto& [object, mention] : mentions_) open.push_back(object);
    while (!open.empty()) {
      const auto found = parts.find(open.back());
      open.pop_back();
      if (found == parts.end()) continue;
      for (const rdf::TermId part : found->second) {
        if (mentions_.contains(part) || !HasClass(part) || places.IsPlace(part)) continue;
        if (Add(part) != nullptr) open.push_back(part);
      }
    }
  }

  bool HasClass(rdf::TermId term) const {
    return view_.dictionary().Kind(term) != rdf::TermKind::kLiteral &&
           MostSpecificClass(view_, names_, term).has_value();
  }

  void AddPerception(rdf::TermId event, Mention& mention) {
    Perception perception;
    perception.event = event;
    for (const rdf::TermId time : view_.Objects(event, names_.start_time)) {
      const std::optional<Time> read = ToTime(view_.dictionary().Get(time));
      if (!read) {
        mention.remarks.push_back("the time " + Quoted(view_, time) + " of " +
                                  Quoted(view_, event) + " cannot be read");
      }
      if (read && (!perception.time || *read > *perception.time)) perception.time = read;
    }
    for (const rdf::TermId pose : view_.Objects(event, names_.event_occurs_at)) {
      if (IsPlace(pose)) continue;
      if (perception.matrix) Fail(view_, event, "has two pose matrices");
      perception.matrix = pose;
    }
    mention.perceptions.push_back(perception);
  }

  // An event may occur at a place or at a pose; what nothing is known of should have been a pose.
  bool IsPlace(rdf::TermId term) const {
    return !IsMatrix(view_, names_, term) && view_.Estimate({term, names_.type, rdf::kAnyTerm}) > 0;
  }

  void AddEntry(rdf::TermId entry) {
    const std::vector<rdf::TermId> objects = view_.Objects(entry, names_.stands_for);
    if (objects.empty()) {
      Add(entry);
      return;
    }
    const auto as_object = mentions_.extract(entry);
    for (const rdf::TermId object : objects) {
      Mention* mention = Add(object);
      if (mention == nullptr) continue;
      auto& entries = mention->entries;
      if (std::find(entries.begin(), entries.end(), entry) == entries.end()) {
        entries.push_back(entry);
      }
      if (as_object.empty()) continue;
      const auto& perceptions = as_object.mapped().perceptions;
      mention->perceptions.insert(mention->perceptions.end(), perceptions.begin(),
                                  perceptions.end());
    }
  }

  const rdf::View& view_;
  const Names& names_;
  Mentions mentions_;
};

// The object and the entries that stand for it.
std::vector<rdf::TermId> Subjects(rdf::TermId object, const Mention& mention) {
  std::vector<rdf::TermId> subjects = {object};
  subjects.insert(subjects.end(), mention.entries.begin(), mention.entries.end());
  return subjects;
}

std::string Text(const rdf::View& view, rdf::TermId term) {
  const rdf::TermView value = view.dictionary().Get(term);
  return (value.kind == rdf::TermKind::kBlank ? "_:" : "") + std::string(value.value);
}

// Perceptions oldest first, those without a time before all; equal times by IRI.
void SortPerceptions(const rdf::View& view, Mention& mention) {
  std::sort(mention.perceptions.begin(), mention.perceptions.end(),
            [&](const Perception& a, const Perception& b) {
              if (a.time != b.time) return a.time < b.time;
              return Text(view, a.event) < Text(view, b.event);
            });
}

std::optional<rdf::TermId> ChooseMatrix(const rdf::View& view, const Names& names,
                                        rdf::TermId object, const Mention& mention) {
  for (auto latest = mention.perceptions.rbegin(); latest != mention.perceptions.rend(); ++latest) {
    if (latest->matrix) return latest->matrix;
  }
  std::optional<rdf::TermId> own;
  for (const rdf::TermId subject : Subjects(object, mention)) {
    for (const rdf::TermId matrix : view.Objects(subject, names.orientation)) {
      if (own && *own != matrix) Fail(view, object, "has two pose matrices");
      own = matrix;
    }
  }
  return own;
}

std::optional<Eigen::Vector3d> ReadExtent(const rdf::View& view, const Names& names,
                                          rdf::TermId object, const Mention& mention) {
  const std::vector<rdf::TermId> subjects = Subjects(object, mention);
  const auto depth_m = FindNumber(view, subjects, names.depth, "depthOfObject");
  const auto width_m = FindNumber(view, subjects, names.width, "widthOfObject");
  const auto height_m = FindNumber(view, subjects, names.height, "heightOfObject");
  for (const auto& side_m : {depth_m, width_m, height_m}) {
    if (side_m && *side_m < 0) Fail(view, object, "a side of it is shorter than nothing");
  }
  if (!depth_m || !width_m || !height_m) return std::nullopt;
  const Eigen::Vector3d extent_m(*depth_m, *width_m, *height_m);
  return extent_m.isZero(0) ? std::nullopt : std::optional<Eigen::Vector3d>(extent_m);
}

std::optional<double> ReadExistence(const rdf::View& view, const Names& names, rdf::TermId object,
                                    const Mention& mention) {
  const auto probability = FindNumber(view, Subjects(object, mention), names.existence_probability,
                                      "existenceProbability");
  if (probability && (*probability < 0 || *probability > 1)) {
    Fail(view, object, "existenceProbability is not between 0 and 1");
  }
  return probability;
}

void ReadTimes(const rdf::View& view, const Names& names, rdf::TermId term, const Mention& mention,
               MapObject& object) {
  const auto include = [&](Time time) {
    if (!object.first_seen || time < *object.first_seen) object.first_seen = time;
    if (!object.last_seen || time > *object.last_seen) object.last_seen = time;
  };
  for (const Perception& perception : mention.perceptions) {
    if (perception.time) include(*perception.time);
  }
  for (const rdf::TermId subject : Subjects(term, mention)) {
    for (const rdf::TermId property : {names.first_seen, names.last_seen}) {
      for (const rdf::TermId value : view.Objects(subject, property)) {
        const std::optional<Time> time = ToTime(view.dictionary().Get(value));
        if (!time) {
          Fail(view, subject, Text(view, property) + " is not a time: " + Text(view, value));
        }
        include(*time);
      }
    }
  }
}

std::string ReadModel(const rdf::View& view, const Names& names, rdf::TermId object,
                      const Mention& mention) {
  std::vector<rdf::TermId> subjects;  // latest first
  for (auto latest = mention.perceptions.rbegin(); latest != mention.perceptions.rend(); ++latest) {
    subjects.push_back(latest->event);
  }
  for (const rdf::TermId subject : Subjects(object, mention)) subjects.push_back(subject);
  for (const rdf::TermId subject : subjects) {
    std::vector<std::string> models;
    for (const rdf::TermId model : view.Objects(subject, names.recognized_using_model)) {
      models.push_back(Text(view, model));
    }
    if (!models.empty()) return *std::min_element(models.begin(), models.end());
  }
  return {};
}

void ReadBelonging(const rdf::View& view, const Names& names,
                   const std::vector<rdf::TermId>& subjects, MapObject& object) {
  const Parts parts(view, names);
  for (const rdf::TermId subject : subjects) {
    const Belonging belonging = parts.BelongingOf(subject);
    if (object.part_of.empty() && belonging.whole) object.part_of = Text(view, *belonging.whole);
    if (object.room.empty() && belonging.room) object.room = Text(view, *belonging.room);
    if (!object.maps.empty()) continue;
    for (const rdf::TermId map : belonging.maps) object.maps.push_back(Text(view, map));
  }
  std::sort(object.maps.begin(), object.maps.end());
}

MapObject Interpret(const rdf::View& view, const Names& names, Frames& frames, rdf::TermId term,
                    const Mention& mention) {
  MapObject object;
  object.iri = Text(view, term);
  object.label = view.Label(term);
  for (const rdf::TermId subject : Subjects(term, mention)) {
    const auto most_specific = MostSpecificClass(view, names, subject);
    if (!most_specific || !object.class_iri.empty()) continue;
    object.class_iri = Text(view, *most_specific);
    object.class_as_written = view.AsWritten(*most_specific);
  }
  object.remarks = mention.remarks;
  if (mention.matrix) {
    try {
      const FramePose& pose = frames.Resolve(*mention.matrix);
      object.map_from_object = pose.map_from_frame;
      object.remarks.insert(object.remarks.end(), pose.remarks.begin(), pose.remarks.end());
    } catch (const Error& error) {
      throw Error(error.code(), "object " + Quoted(view, term) + ": " + error.what());
    }
  }
  object.extent_m = ReadExtent(view, names, term, mention);
  object.existence = ReadExistence(view, names, term, mention);
  ReadTimes(view, names, term, mention, object);
  object.recognised_with = ReadModel(view, names, term, mention);
  ReadBelonging(view, names, Subjects(term, mention), object);
  return object;
}

}  // namespace

std::vector<MapObject> ReadMapObjects(const rdf::View& view) {
  if (view.layers().empty()) return {};
  const Names names(view.dictionary());
  Mentions mentions = Collector(view, names).Run();
  std::map<rdf::TermId, rdf::TermId> matrices;
  for (auto& [object, mention] : mentions) {
    SortPerceptions(view, mention);
    mention.matrix = ChooseMatrix(view, names, object, mention);
    if (mention.matrix) matrices.emplace(object, *mention.matrix);
  }
  Frames frames(view, names, matrices);
  std::vector<MapObject> objects;
  for (const auto& [term, mention] : mentions) {
    objects.push_back(Interpret(view, names, frames, term, mention));
  }
  std::sort(objects.begin(), objects.end(),
            [](const MapObject& a, const MapObject& b) { return a.iri < b.iri; });
  return objects;
}

std::optional<std::array<double, 6>> BoundsOf(const std::vector<MapObject>& objects) {
  Eigen::AlignedBox3d box;
  for (const MapObject& object : objects) {
    if (!object.map_from_object) continue;
    const Eigen::Vector3d half_m = object.extent_m.value_or(Eigen::Vector3d::Zero()) / 2;
    const Eigen::Vector3d reach_m =
        object.map_from_object->rotation.toRotationMatrix().cwiseAbs() * half_m;
    box.extend(object.map_from_object->translation_m - reach_m);
    box.extend(object.map_from_object->translation_m + reach_m);
  }
  if (box.isEmpty()) return std::nullopt;
  return std::array<double, 6>{box.min().x(), box.min().y(), box.min().z(),
                               box.max().x(), box.max().y(), box.max().z()};
}

}  // namespace lares::semantic
