#include "robots/urdf/structure.h"

#include <map>
#include <set>

#include "base/text.h"
#include "robots/urdf/quote.h"

namespace lares::urdf {
namespace {

using Severity = Finding::Severity;

constexpr std::size_t kMostNamed = 8;

template <typename Part>
std::map<std::string, int> LinesByName(const std::vector<Part>& parts, const std::string& noun,
                                       Reading& reading) {
  std::map<std::string, int> lines;
  for (const Part& part : parts) {
    if (part.name.empty()) continue;
    const auto [at, is_new] = lines.emplace(part.name, part.line);
    if (!is_new) {
      reading.Fault("twice", part.line,
                    "the " + noun + " " + Quote(part.name) + " is there twice: first in line " +
                        std::to_string(at->second),
                    "give one of them another name");
    }
  }
  return lines;
}

// Says what a name may have stood for. Each answer compares the name with all that are known, so
// only the first names get one, and none where that is much work: a document of a few megabytes
// must not take minutes to refuse.
class Suggestions {
 public:
  std::string Alike(const std::string& name, const std::map<std::string, int>& known) {
    if (left_ == 0 || known.size() * name.size() * name.size() > kMostCompared) return "";
    --left_;
    std::vector<std::string> names;
    for (const auto& [each, line] : known) names.push_back(each);
    const auto similar = SimilarNames(name, names);
    return similar.empty() ? "" : "did you mean " + Join(similar, " or ") + "?";
  }

 private:
  static constexpr std::size_t kMostCompared = 20'000'000;  // pairs of characters for one name
  std::size_t left_ = kMostSuggested;
};

void CheckReferences(const RawRobot& robot, const std::map<std::string, int>& links,
                     const std::map<std::string, int>& joints, Reading& reading) {
  Suggestions suggestions;
  for (const RawJoint& joint : robot.joints) {
    for (const auto& [end, link] : {std::pair("parent", joint.parent), {"child", joint.child}}) {
      if (link.empty() || links.contains(link)) continue;
      reading.Fault("no-link", joint.line,
                    "the joint " + Quote(joint.name) + " has the " + end + " " + Quote(link) +
                        ", and there is no such link",
                    suggestions.Alike(link, links));
    }
    if (!joint.mimic.empty() && !joints.contains(joint.mimic)) {
      reading.Add(Severity::kWarning, "no-joint", joint.line,
                  "the joint " + Quote(joint.name) + " follows " + Quote(joint.mimic) +
                      ", and there is no such joint",
                  suggestions.Alike(joint.mimic, joints));
    }
  }
  for (const RawSensor& sensor : robot.sensors) {
    // Sensors of force and torque sit on joints.
    if (links.contains(sensor.link) || joints.contains(sensor.link)) continue;
    reading.Add(Severity::kWarning, "sensor-nowhere", sensor.sensor.line,
                "the sensor " + Quote(sensor.sensor.name) + " sits on the link " +
                    Quote(sensor.link) + ", and there is no such link; it is left out",
                suggestions.Alike(sensor.link, links));
  }
}

// Walks down from `root`; what it reaches is taken out of `unreached`. The first joint that is
// further out than `max_chain`, or null.
const RawJoint* Reach(const std::string& root,
                      const std::map<std::string, std::vector<const RawJoint*>>& below,
                      std::size_t max_chain, std::map<std::string, int>& unreached) {
  const RawJoint* too_far = nullptr;
  std::vector<std::pair<std::string, std::size_t>> open{{root, 0}};
  while (!open.empty()) {
    const auto [link, depth] = std::move(open.back());
    open.pop_back();
    if (unreached.erase(link) == 0) continue;
    const auto joints = below.find(link);
    if (joints == below.end()) continue;
    for (const RawJoint* joint : joints->second) {
      if (depth >= max_chain && too_far == nullptr) too_far = joint;
      open.emplace_back(joint->child, depth + 1);
    }
  }
  return too_far;
}

void CheckTree(const RawRobot& robot, const std::map<std::string, int>& links, const Limits& limits,
               Reading& reading) {
  std::map<std::string, const RawJoint*> above;
  std::map<std::string, std::vector<const RawJoint*>> below;
  for (const RawJoint& joint : robot.joints) {
    if (!links.contains(joint.parent) || !links.contains(joint.child)) continue;
    const auto [at, is_new] = above.emplace(joint.child, &joint);
    if (!is_new) {
      reading.Fault("two-parents", joint.line,
                    "the link " + Quote(joint.child) + " hangs on two joints, " +
                        Quote(at->second->name) + " and " + Quote(joint.name),
                    "a URDF is a tree: keep one of the joints");
      continue;
    }
    below[joint.parent].push_back(&joint);
  }
  std::vector<std::pair<std::string, int>> roots;
  for (const RawLink& link : robot.links) {
    if (!link.name.empty() && !above.contains(link.name)) roots.emplace_back(link.name, link.line);
  }
  if (roots.size() > 1) {
    std::vector<std::string> names;
    for (const auto& [name, line] : roots) {
      if (names.size() < kMostNamed) names.push_back(Quote(name));
    }
    reading.Fault("two-roots", roots[1].second,
                  "there are " + std::to_string(roots.size()) + " links that no joint carries: " +
                      Join(names, ", ") + (names.size() < roots.size() ? ", …" : ""),
                  "a robot has one root: join the others to it, or take them out");
  }
  std::map<std::string, int> unreached = links;
  for (const auto& [root, line] : roots) {
    const RawJoint* too_far = Reach(root, below, limits.max_chain, unreached);
    if (too_far == nullptr) continue;
    reading.Fault("long-chain", too_far->line,
                  "the joint " + Quote(too_far->name) + " is more than " +
                      std::to_string(limits.max_chain) +
                      " joints away from the root (the limit max_chain)");
  }
  if (unreached.empty()) return;
  // All that is left hangs on a circle: go up until a link comes again.
  std::string link = unreached.begin()->first;
  std::set<std::string> seen;
  while (seen.insert(link).second && above.contains(link)) link = above[link]->parent;
  std::vector<std::string> circle{Quote(link)};
  int line = 0;
  for (std::string at = link; above.contains(at);) {
    line = above[at]->line;
    at = above[at]->parent;
    circle.push_back(Quote(at));
    if (at == link || circle.size() > kMostNamed) break;
  }
  reading.Fault("circle", line, "links and joints go in a circle: " + Join(circle, " on "),
                "a URDF is a tree: take one of the joints out");
}

}  // namespace

void CheckStructure(const RawRobot& robot, const Limits& limits, Reading& reading) {
  const std::map<std::string, int> links = LinesByName(robot.links, "link", reading);
  const std::map<std::string, int> joints = LinesByName(robot.joints, "joint", reading);
  if (robot.links.empty()) reading.Fault("no-links", 1, "the robot has no links");
  CheckReferences(robot, links, joints, reading);
  CheckTree(robot, links, limits, reading);
}

}  // namespace lares::urdf
