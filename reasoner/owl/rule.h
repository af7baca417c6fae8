// Rules as data: what the join engine runs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

// One row of the rule table, as text. Patterns are separated by " . ", terms by blanks: ?variable,
// a (rdf:type), rdf:, rdfs: or owl: name, or (as an object) an integer, which any literal of that
// value matches.
//
// A rule is cut in two. `schema` patterns speak about classes and properties: they are few, and
// each way to satisfy them makes an *instance* of the rule. `data` patterns are what instances wait
// for; each has one key term, constant in the instance, under which the engine finds it.
//
// In `schema`, "?l LIST ?m" takes each member of the RDF list ?l in turn, "?l LIST ?m ?n" each pair
// of members. "@name" as `data` means that the patterns depend on the length of the list ?l: the
// procedure of that name in lists.cc writes them.
//
// `head` is what follows; empty for a contradiction.
struct RuleRow {
  const char* name;  // as in W3C OWL 2 Profiles, section 4.3
  int table;         // there
  const char* schema;
  const char* data;
  const char* head;
};

// All rows, in the order of the tables.
std::span<const RuleRow> RuleTable();

// What is true without premises: ?subject a ?object. Names as in RuleRow.
struct AxiomRow {
  const char* name;  // "cls-thing"
  int table;
  const char* subject;
  const char* object;
};
// cls-thing, cls-nothing1 and prp-ap; dt-type1 is rdf::SupportedDatatypes().
std::span<const AxiomRow> AxiomTable();

// A constant, or the number of a variable.
struct Slot {
  bool is_variable = false;
  std::uint32_t value = 0;

  // kAnyTerm for a variable without a value.
  rdf::TermId In(const std::vector<rdf::TermId>& binding) const {
    return is_variable ? binding[value] : rdf::TermId{value};
  }
};

struct Atom {
  Slot subject, predicate, object;
  int number = -1;  // when not negative: the object is a literal of this value

  rdf::Pattern In(const std::vector<rdf::TermId>& binding) const {
    return {subject.In(binding), predicate.In(binding), object.In(binding)};
  }
};

enum class ListUse { kNone, kEach, kPairs, kWhole };

struct Rule {
  std::string name;
  int table = 0;
  std::uint32_t number = 0;  // 1-based row; instances written for a list share their row's number
  std::vector<Atom> schema, data, heads;
  std::uint32_t variables = 0;
  std::vector<bool> is_bound_by_schema;  // by variable
  ListUse list_use = ListUse::kNone;
  std::string list_procedure;
  std::uint32_t list = 0, first_member = 0, second_member = 0;  // variables
  // x P y, y P z → x P z: run by TransitiveClosure.
  bool is_transitive = false;
  // eq-sym, eq-trans, eq-rep-*: what representatives (rdf::Equality) stand for.
  bool is_equality = false;
  // What it concludes need not be fed to it again, for its schema patterns are themselves closed.
  bool is_self_closed = false;

  bool is_contradiction() const { return heads.empty() && list_use != ListUse::kWhole; }
};

// The terms that the engine knows by name.
struct Vocabulary {
  explicit Vocabulary(rdf::Dictionary& dictionary);
  rdf::TermId type, first, rest, nil, same_as, sub_class_of, sub_property_of, equivalent_class,
      equivalent_property, thing, nothing;
};

std::vector<Rule> CompileRules(std::span<const RuleRow> rows, rdf::Dictionary& dictionary);

// Whether `literal` has a numeric datatype and that value; blanks around it are overlooked.
bool HasValue(const rdf::TermView& literal, int value);

// "rdf:type" and the like, or the whole IRI.
std::string Expand(std::string_view name);

}  // namespace lares::owl
