#include "mapping/semantic/place_facts.h"

#include <algorithm>
#include <set>

#include "mapping/semantic/parts.h"

namespace lares::semantic {
namespace {

using Terms = std::set<rdf::TermId>;

class Reader {
 public:
  explicit Reader(const rdf::View& view)
      : view_(view), names_(view.dictionary()), parts_(view_, names_) {}

  PlaceFacts Run(const std::vector<MapObject>& objects) {
    const Terms described = Described();
    Terms inside = described;  // with the rooms of a flat
    for (const rdf::TermId place : places_) {
      for (const rdf::TermId whole : parts_.Wholes(place)) {
        if (described.contains(whole) && Rank(place) <= Rank(whole)) inside.insert(place);
      }
    }
    Terms around = Around(described);
    PlaceFacts facts;
    for (const rdf::TermId place : inside) AddTexts(place, names_.room_number, facts.room_numbers);
    around.insert(inside.begin(), inside.end());  // the map may be of a whole storey or building
    for (const rdf::TermId place : around) AddAddress(place, facts);
    const Terms outermost = Outermost(described);
    for (const rdf::TermId place : outermost) AddClasses(place, facts.place_classes);
    for (const MapObject& object : objects) {
      const auto term = Find(object.iri);
      if (term && !outermost.contains(*term)) AddClasses(*term, facts.held_classes);
    }
    for (const rdf::TermId map : maps_) AddClasses(map, facts.map_classes);
    for (auto* list :
         {&facts.room_numbers, &facts.levels, &facts.buildings, &facts.streets, &facts.cities,
          &facts.place_classes, &facts.held_classes, &facts.map_classes}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return facts;
  }

 private:
  // Cities enclose streets, these buildings, these storeys, these all other places.
  int Rank(rdf::TermId place) const {
    if (parts_.Is(place, names_.city)) return 4;
    if (parts_.Is(place, names_.street)) return 3;
    if (parts_.Is(place, names_.building)) return 2;
    if (parts_.Is(place, names_.storey)) return 1;
    return 0;
  }

  template <typename Visit>
  void ForEachOnTop(rdf::TermId predicate, const Visit& visit) const {
    const rdf::Layer& top = *view_.layers().back();
    for (const rdf::Triple& triple : top.Range({rdf::kAnyTerm, predicate, rdf::kAnyTerm})) {
      visit(triple);
    }
    for (const rdf::Graph& graph : top.graphs()) {
      for (const rdf::Triple& triple : graph.triples) {
        if (triple.predicate == predicate) visit(triple);
      }
    }
  }

  Terms Described() {
    ForEachOnTop(names_.type, [&](const rdf::Triple& triple) {
      if (parts_.Is(triple.subject, names_.map)) maps_.insert(triple.subject);
      if (!places_.contains(triple.subject) && parts_.IsPlace(triple.subject)) {
        places_.insert(triple.subject);
      }
    });
    Terms described;
    ForEachOnTop(names_.described_in_map, [&](const rdf::Triple& triple) {
      maps_.insert(triple.object);
      if (parts_.IsPlace(triple.subject)) described.insert(triple.subject);
    });
    if (!described.empty()) return described;
    for (const rdf::TermId place : places_) {
      const bool encloses = std::any_of(places_.begin(), places_.end(), [&](rdf::TermId other) {
        return other != place && Rank(other) < Rank(place) && Connected(other, place);
      });
      if (!encloses && Rank(place) == 0) described.insert(place);
    }
    return described.empty() ? places_ : described;
  }

  bool Connected(rdf::TermId a, rdf::TermId b) const {
    return view_.Contains({a, names_.proper_parts, b}) ||
           view_.Contains({b, names_.proper_parts, a});
  }

  // The storeys, buildings, streets and cities that `described` are in.
  Terms Around(const Terms& described) const {
    Terms around;
    std::vector<rdf::TermId> open(described.begin(), described.end());
    while (!open.empty()) {
      const rdf::TermId place = open.back();
      open.pop_back();
      std::vector<rdf::TermId> neighbours = parts_.Wholes(place);
      for (const rdf::TermId reversed : view_.Objects(place, names_.proper_parts)) {
        neighbours.push_back(reversed);
      }
      for (const rdf::TermId other : neighbours) {
        if (Rank(other) > Rank(place) && around.insert(other).second) open.push_back(other);
      }
    }
    if (!around.empty()) return around;
    for (const rdf::TermId place : places_) {
      if (Rank(place) > 0) around.insert(place);
    }
    return around;
  }

  // Those that are no part of another one: the flat, not its rooms.
  Terms Outermost(const Terms& described) const {
    Terms outermost;
    for (const rdf::TermId place : described) {
      const std::vector<rdf::TermId> wholes = parts_.Wholes(place);
      const bool is_part = std::any_of(wholes.begin(), wholes.end(), [&](rdf::TermId whole) {
        return described.contains(whole) && Rank(whole) >= Rank(place);
      });
      if (!is_part) outermost.insert(place);
    }
    return outermost.empty() ? described : outermost;
  }

  void AddAddress(rdf::TermId place, PlaceFacts& facts) const {
    switch (Rank(place)) {
      case 4:
        return AddNames(place, facts.cities);
      case 3:
        return AddNames(place, facts.streets);
      case 2:
        AddNames(place, facts.buildings);
        return AddTexts(place, names_.street_number, facts.buildings);
      case 1: {
        const std::size_t before = facts.levels.size();
        AddTexts(place, names_.floor_number, facts.levels);
        if (facts.levels.size() == before) AddNames(place, facts.levels);
        return;
      }
      default:
        return;
    }
  }

  void AddTexts(rdf::TermId subject, rdf::TermId property, std::vector<std::string>& to) const {
    for (const rdf::TermId value : view_.Objects(subject, property)) {
      if (view_.dictionary().Kind(value) != rdf::TermKind::kLiteral) continue;
      to.emplace_back(view_.dictionary().Get(value).value);
    }
  }

  // All labels, in any language; the local name of what has none.
  void AddNames(rdf::TermId place, std::vector<std::string>& to) const {
    const std::size_t before = to.size();
    AddTexts(place, names_.label, to);
    if (to.size() == before) to.push_back(view_.Label(place));
  }

  void AddClasses(rdf::TermId thing, std::vector<std::string>& to) const {
    for (const rdf::TermId kind : view_.Objects(thing, names_.type)) {
      const rdf::TermView term = view_.dictionary().Get(kind);
      const bool is_of_owl =
          term.value.starts_with(rdf::kOwl) || term.value.starts_with(rdf::kRdfs);
      if (term.kind == rdf::TermKind::kIri && !is_of_owl) to.emplace_back(term.value);
    }
  }

  std::optional<rdf::TermId> Find(const std::string& iri) const {
    if (iri.starts_with("_:")) {
      return view_.dictionary().Intern({rdf::TermKind::kBlank, std::string_view(iri).substr(2)});
    }
    return view_.dictionary().FindIri(iri);
  }

  const rdf::View& view_;
  Names names_;
  Parts parts_;
  Terms places_;  // of the top layer
  Terms maps_;
};

}  // namespace

PlaceFacts ReadPlaceFacts(const rdf::View& view, const std::vector<MapObject>& objects) {
  if (view.layers().empty()) return {};
  return Reader(view).Run(objects);
}

}  // namespace lares::semantic
