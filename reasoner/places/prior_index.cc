#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "reasoner/places/prior.h"

namespace lares::places {
namespace {

std::vector<std::string> SortedPlaces(const PriorTable& table) {
  std::set<std::string_view> places;
  for (const PriorRow& row : table.rows) places.insert(row.place);
  return {places.begin(), places.end()};
}

}  // namespace

PriorIndex::PriorIndex(const PriorTable& table)
    : places_(SortedPlaces(table)), place_totals_(places_.size(), 0) {
  for (const PriorRow& row : table.rows) {
    const auto place = std::lower_bound(places_.begin(), places_.end(), row.place);
    const auto index = static_cast<std::uint32_t>(place - places_.begin());
    objects_[row.object].push_back({index, row.count});
    place_totals_[index] += row.count;
    total_ += row.count;
  }
}

std::vector<RankedPlace> PriorIndex::Rank(std::string_view object, double lambda) const {
  if (!(lambda >= 0) || !std::isfinite(lambda)) {
    throw Error(Code::kInvalid, "lambda must be a finite number that is not negative");
  }
  const auto counts = objects_.find(std::string(object));
  if (counts == objects_.end()) return {};
  std::vector<RankedPlace> ranked;
  for (const std::string& place : places_) ranked.push_back({place, 0, 0});
  for (const Count& count : counts->second) ranked[count.place].support += count.count;

  const double smoothed_classes = lambda * static_cast<double>(objects_.size());
  double evidence = 0;  // P(O)
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    if (place_totals_[i] <= 0) continue;  // P(place) is 0
    const double likelihood = (ranked[i].support + lambda) / (place_totals_[i] + smoothed_classes);
    ranked[i].probability = likelihood * place_totals_[i] / total_;
    evidence += ranked[i].probability;
  }
  if (!(evidence > 0)) return {};  // counted nowhere, and nothing smoothed
  for (RankedPlace& place : ranked) place.probability /= evidence;
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedPlace& a, const RankedPlace& b) {
    return a.probability > b.probability;
  });
  return ranked;
}

std::vector<RankedPlace> RankPlaces(const PriorTable& table, std::string_view object,
                                    double lambda) {
  return PriorIndex(table).Rank(object, lambda);
}

PriorTable OnlyPlaces(const PriorTable& table,
                      const std::function<bool(std::string_view place)>& keep) {
  PriorTable kept{table.name, table.title, {}};
  for (const PriorRow& row : table.rows) {
    if (keep(row.place)) kept.rows.push_back(row);
  }
  return kept;
}

}  // namespace lares::places
