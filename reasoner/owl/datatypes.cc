// Table 8 of W3C OWL 2 Profiles: what literals are, and are not.
#include <algorithm>
#include <optional>

#include "ontology/rdf/literal_value.h"
#include "reasoner/owl/engine.h"
#include "reasoner/owl/on_demand.h"

namespace lares::owl {

// dt-type2
bool Engine::IsInDatatype(rdf::TermId literal, rdf::TermId datatype) const {
  const auto value = rdf::ValueOf(dictionary_.Get(literal));
  return value && rdf::IsInDatatype(*value, dictionary_.Get(datatype).value);
}

bool Engine::IsOutsideDatatype(rdf::TermId literal, rdf::TermId datatype) const {
  return owl::IsOutsideDatatype(dictionary_.Get(literal), dictionary_.Get(datatype).value);
}

// Whether an instance asks for nothing but members of datatypes, so that no other triple wakes it.
bool Engine::IsTypedByDatatypes(const Rule& rule, const std::vector<rdf::TermId>& binding) const {
  return std::all_of(rule.data.begin(), rule.data.end(), [&](const Atom& atom) {
    const rdf::Pattern pattern = atom.In(binding);
    return pattern.predicate == words_.type && pattern.subject == rdf::kAnyTerm &&
           IsDatatype(pattern.object);
  });
}

// From here on each literal of `datatype` is a fact. Before there are any facts it is an instance
// of the layers below that asks, which has seen the literals there.
void Engine::WatchDatatype(rdf::TermId datatype) {
  const auto known = std::find(watched_datatypes_.begin(), watched_datatypes_.end(), datatype);
  if (known == watched_datatypes_.end()) watched_datatypes_.push_back(datatype);
  if (!is_prepared_ || !scanned_datatypes_.Insert(Number(datatype))) return;
  typed_literals_ = {};
  std::vector<rdf::TermId> literals;
  ForEachKnown({}, [&](const rdf::Triple& triple) {
    if (IsLiteral(triple.object)) literals.push_back(triple.object);
  });
  for (const rdf::TermId literal : literals) TypeWatched(literal);
}

void Engine::TypeWatched(rdf::TermId literal) {
  if (!typed_literals_.Insert(Number(literal))) return;
  const auto value = rdf::ValueOf(dictionary_.Get(literal));
  if (!value) return;
  for (const rdf::TermId datatype : watched_datatypes_) {
    if (rdf::IsInDatatype(*value, dictionary_.Get(datatype).value)) {
      facts_.Add({literal, words_.type, datatype}, kHidden);
    }
  }
}

// dt-not-type for what is the same as a literal.
void Engine::CheckType(const rdf::Triple& triple) {
  if (equality_.empty() || !IsDatatype(triple.object)) return;
  for (const rdf::TermId member : equality_.Members(triple.subject)) {
    if (IsLiteral(member) && IsOutsideDatatype(member, triple.object)) {
      AddClash("dt-not-type", {triple, {triple.subject, words_.same_as, member}});
      return;
    }
  }
}

// dt-type2, dt-not-type and dt-diff for a class of equal terms that may have come to hold literals.
void Engine::CheckValuesOf(rdf::TermId representative) {
  std::optional<rdf::DataValue> known;
  rdf::TermId known_literal{};
  for (const rdf::TermId member : equality_.Members(representative)) {
    if (!IsLiteral(member)) continue;
    const auto value = rdf::ValueOf(dictionary_.Get(member));
    if (!value) continue;
    if (known && *known != *value) {
      AddClash("eq-diff1", {{known_literal, words_.same_as, member}});
    }
    known = value;
    known_literal = member;
  }
  for (const rdf::Triple& type : Match({representative, words_.type, {}})) CheckType(type);
  if (!known) return;
  for (const std::string_view datatype : rdf::SupportedDatatypes()) {
    if (!rdf::IsInDatatype(*known, datatype)) continue;
    Derive({representative, words_.type, dictionary_.InternIri(datatype)}, kOfDatatype);
  }
}

}  // namespace lares::owl
