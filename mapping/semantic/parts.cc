#include "mapping/semantic/parts.h"

#include <algorithm>
#include <set>

namespace lares::semantic {
namespace {

constexpr std::size_t kMaxWholes = 64;

}  // namespace

// Those that are part of most others come first: in a closed chain these are the nearest.
std::vector<rdf::TermId> Parts::DirectWholes(rdf::TermId thing) const {
  std::vector<rdf::TermId> wholes = view_.Objects(thing, names_.proper_part_of);
  view_.ForEach({rdf::kAnyTerm, names_.proper_parts, thing}, [&](const rdf::Triple& triple) {
    wholes.push_back(triple.subject);
    return true;
  });
  std::sort(wholes.begin(), wholes.end());
  wholes.erase(std::unique(wholes.begin(), wholes.end()), wholes.end());
  const auto depth = [&](rdf::TermId whole) {
    return view_.Estimate({rdf::kAnyTerm, names_.proper_parts, whole});
  };
  std::stable_sort(wholes.begin(), wholes.end(),
                   [&](rdf::TermId a, rdf::TermId b) { return depth(a) > depth(b); });
  return wholes;
}

std::vector<rdf::TermId> Parts::Wholes(rdf::TermId thing) const {
  std::vector<rdf::TermId> wholes;
  std::set<rdf::TermId> seen{thing};
  std::vector<rdf::TermId> next = DirectWholes(thing);
  for (std::size_t expanded = 0;; ++expanded) {
    for (const rdf::TermId whole : next) {
      if (wholes.size() < kMaxWholes && seen.insert(whole).second) wholes.push_back(whole);
    }
    if (expanded == wholes.size()) return wholes;
    next = DirectWholes(wholes[expanded]);
  }
}

Belonging Parts::BelongingOf(rdf::TermId thing) const {
  Belonging belonging;
  const std::vector<rdf::TermId> wholes = Wholes(thing);
  if (!wholes.empty()) belonging.whole = wholes.front();
  belonging.maps = view_.Objects(thing, names_.described_in_map);
  const std::vector<rdf::TermId> inside = view_.Objects(thing, names_.inside_room);
  if (!inside.empty()) belonging.room = *std::min_element(inside.begin(), inside.end());
  for (const rdf::TermId whole : wholes) {
    if (belonging.maps.empty()) belonging.maps = view_.Objects(whole, names_.described_in_map);
    if (!belonging.room && Is(whole, names_.room)) belonging.room = whole;
  }
  return belonging;
}

bool Parts::IsPlace(rdf::TermId thing) const {
  if (view_.layers().empty()) return false;
  for (const rdf::TermId kind :
       {names_.room, names_.storey, names_.building, names_.street, names_.city}) {
    if (Is(thing, kind)) return true;
  }
  const rdf::Layer& own = *view_.layers().front();
  bool is_place = view_.IsAsserted({thing, names_.type, names_.place});
  view_.ForEach({thing, names_.type, rdf::kAnyTerm}, [&](const rdf::Triple& triple) {
    is_place = is_place || (triple.object != names_.place &&
                            own.Contains({triple.object, names_.sub_class_of, names_.place}));
    return !is_place;
  });
  return is_place;
}

}  // namespace lares::semantic
