#include "recipes/match/repairs.h"

#include <algorithm>
#include <limits>

#include "recipes/match/words.h"

namespace lares::recipes {

namespace {

// Bounds of one quantity become one.
void Narrow(const Bound& bound, std::vector<Measure>& measures) {
  auto known = std::find_if(measures.begin(), measures.end(), [&](const Measure& measure) {
    return measure.quantity.iri == bound.quantity.iri;
  });
  if (known == measures.end()) {
    Measure& measure = measures.emplace_back();
    measure.quantity = bound.quantity;
    measure.unit = bound.unit;
    measure.at_least = bound.least;
    measure.at_most = bound.most;
    measure.stated_by = bound.stated_by;
    return;
  }
  if (bound.least) known->at_least = std::max(known->at_least.value_or(*bound.least), *bound.least);
  if (bound.most) known->at_most = std::min(known->at_most.value_or(*bound.most), *bound.most);
}

RepairItem ToItem(const Needs& needs, const Assessment& assessment, std::size_t addition) {
  const Assessment::Added& added = assessment.additions[addition];
  const NeedNode& node = needs.nodes[added.node];
  RepairItem item;
  item.what = node.what;
  item.cost = static_cast<double>(assessment.problem.additions[addition].cost) / kCostScale;
  // What is there already need not be kept by the new part too.
  for (const std::size_t group : added.groups) {
    if (assessment.groups[group].is_there) continue;
    for (const Bound& bound : needs.groups[group].bounds) Narrow(bound, item.bounds);
  }
  item.text = node.what.label;
  if (!item.bounds.empty()) item.text += " with " + TextOf(item.bounds);
  return item;
}

}  // namespace

NamedRepairs FindRepairs(const Needs& needs, const Assessment& assessment,
                         const RepairOptions& options) {
  NamedRepairs named;
  if (assessment.feasible) return named;
  const RepairSets found = SmallestRepairs(assessment.problem, options);
  named.is_smallest = found.proven;
  for (const RepairSet& set : found.sets) {
    Repair& repair = named.repairs.emplace_back();
    repair.cost = static_cast<double>(set.cost) / kCostScale;
    for (const std::size_t addition : set.additions) {
      repair.add.push_back(ToItem(needs, assessment, addition));
    }
    std::sort(repair.add.begin(), repair.add.end(), [](const RepairItem& a, const RepairItem& b) {
      return a.what.label != b.what.label ? a.what.label < b.what.label : a.what.iri < b.what.iri;
    });
  }
  return named;
}

}  // namespace lares::recipes
