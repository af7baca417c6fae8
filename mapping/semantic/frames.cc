#include "mapping/semantic/frames.h"

#include <algorithm>

#include "base/error.h"
#include "mapping/semantic/values.h"

namespace lares::semantic {
namespace {

// Entries rounded to two digits, as people write them, still make a rotation.
constexpr double kEntryTolerance = 5e-3;
constexpr std::size_t kMaxChain = 256;

}  // namespace

bool IsMatrix(const rdf::View& view, const Names& names, rdf::TermId term) {
  if (view.Contains({term, names.type, names.rotation_matrix})) return true;
  for (const auto& row : names.matrix_entry) {
    for (const rdf::TermId entry : row) {
      if (view.Estimate({term, entry, rdf::kAnyTerm}) > 0) return true;
    }
  }
  return false;
}

Frames::Frames(const rdf::View& view, const Names& names,
               std::map<rdf::TermId, rdf::TermId> matrices)
    : view_(view), names_(names), matrices_(std::move(matrices)) {}

bool Frames::HasType(rdf::TermId term, rdf::TermId type) const {
  return view_.Contains({term, names_.type, type});
}

const FramePose& Frames::Resolve(rdf::TermId matrix) {
  if (const auto known = resolved_.find(matrix); known != resolved_.end()) return known->second;
  if (std::find(path_.begin(), path_.end(), matrix) != path_.end()) FailOnCircle(matrix);
  if (path_.size() == kMaxChain) {
    throw Error(Code::kTooLarge,
                Quoted(view_, path_.front()) + " is relative to a chain of more than 256 frames");
  }
  path_.push_back(matrix);
  FramePose pose = Compute(matrix);
  path_.pop_back();
  return resolved_.emplace(matrix, std::move(pose)).first->second;
}

FramePose Frames::Compute(rdf::TermId matrix) {
  FramePose pose = Read(matrix);
  const std::optional<rdf::TermId> base = Base(matrix);
  if (!base || HasType(*base, names_.semantic_environment_map) || HasType(*base, names_.map)) {
    return pose;
  }
  const auto object = matrices_.find(*base);
  if (object == matrices_.end() && !IsMatrix(view_, names_, *base)) {
    pose.map_from_frame.reset();
    pose.remarks.push_back("the pose matrix " + Quoted(view_, matrix) + " is relative to " +
                           Quoted(view_, *base) + ", which has no pose");
    return pose;
  }
  const FramePose& parent = Resolve(object == matrices_.end() ? *base : object->second);
  pose.remarks.insert(pose.remarks.end(), parent.remarks.begin(), parent.remarks.end());
  if (!parent.map_from_frame) {
    pose.map_from_frame.reset();
    return pose;
  }
  pose.map_from_frame = *parent.map_from_frame * *pose.map_from_frame;
  return pose;
}

std::optional<rdf::TermId> Frames::Base(rdf::TermId matrix) const {
  const std::vector<rdf::TermId> bases = view_.Objects(matrix, names_.relative_to);
  if (bases.size() > 1) {
    throw Error(Code::kInvalid, "pose matrix " + Quoted(view_, matrix) + ": is relative to both " +
                                    Quoted(view_, bases[0]) + " and " + Quoted(view_, bases[1]));
  }
  return bases.empty() ? std::nullopt : std::optional<rdf::TermId>(bases[0]);
}

FramePose Frames::Read(rdf::TermId matrix) const {
  FramePose pose;
  Eigen::Matrix4d entries = ReadEntries(matrix);
  if (entries.topLeftCorner<3, 3>().determinant() < 0) {
    entries.col(1).head<3>() *= -1;
    pose.remarks.push_back("the pose matrix " + Quoted(view_, matrix) +
                           " mirrors; its y axis was reversed");
  }
  try {
    pose.map_from_frame = FromMatrix(entries, kEntryTolerance);
  } catch (const Error& error) {
    throw Error(error.code(), "pose matrix " + Quoted(view_, matrix) + ": " + error.what());
  }
  return pose;
}

Eigen::Matrix4d Frames::ReadEntries(rdf::TermId matrix) const {
  Eigen::Matrix4d entries;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const std::string name = "entry m" + std::to_string(row) + std::to_string(column);
      const std::optional<double> number = FindNumber(
          view_, {matrix},
          names_.matrix_entry[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
          name);
      if (!number) {
        throw Error(Code::kInvalid,
                    "pose matrix " + Quoted(view_, matrix) + ": " + name + " is missing");
      }
      entries(row, column) = *number;
    }
  }
  return entries;
}

void Frames::FailOnCircle(rdf::TermId matrix) const {
  std::string circle;
  for (auto frame = std::find(path_.begin(), path_.end(), matrix); frame != path_.end(); ++frame) {
    circle += Quoted(view_, *frame) + " → ";
  }
  throw Error(Code::kInvalid,
              "frames are relative to one another: " + circle + Quoted(view_, matrix));
}

}  // namespace lares::semantic
