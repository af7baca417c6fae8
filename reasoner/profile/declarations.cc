#include "reasoner/profile/declarations.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::profile {
namespace {

enum Role { kClass, kProperty, kIndividual, kRoles };
constexpr const char* kNames[] = {"class", "property", "individual"};
constexpr const char* kPlurals[] = {"classes", "properties", "individuals"};
constexpr std::size_t kMostSuggested = 200;  // terms for which similar names are looked up

bool IsPropertyType(std::string_view word) {
  return word == "owl:ObjectProperty" || word == "owl:DatatypeProperty" ||
         word == "owl:AnnotationProperty" || word == "rdf:Property" ||
         word == "owl:OntologyProperty" || word == "owl:DeprecatedProperty" ||
         (word.starts_with("owl:") && word.ends_with("Property"));
}

bool IsClassType(std::string_view word) {
  return word == "owl:Class" || word == "rdfs:Class" || word == "rdfs:Datatype" ||
         word == "owl:DeprecatedClass";
}

class DeclarationCheck {
 public:
  DeclarationCheck(const DocumentIndex& index, const rdf::View& catalogue,
                   const rdf::AliasTable& aliases, Collector& found)
      : index_(index), catalogue_(catalogue), aliases_(aliases), found_(found) {
    for (auto& uses : uses_) uses.assign(index.document().terms.size(), Collector::kNone);
    for (auto& declared : declared_) declared.assign(index.document().terms.size(), false);
  }

  void Run() {
    const auto count = static_cast<std::uint32_t>(index_.document().statements.size());
    for (std::uint32_t i = 0; i < count; ++i) Declare(i);
    for (std::uint32_t i = 0; i < count; ++i) Use(i);
    for (const Role role : {kClass, kProperty, kIndividual}) ReportRole(role);
    ReportPunning();
  }

 private:
  void Declare(std::uint32_t index) {
    const rdf::Statement& s = index_.Statement(index);
    if (index_.Word(s.predicate) != "rdf:type") return;
    const std::string_view type = index_.Word(s.object);
    if (IsClassType(type)) {
      declared_[kClass][s.subject] = true;
    } else if (IsPropertyType(type)) {
      declared_[kProperty][s.subject] = true;
      if (type == "owl:ObjectProperty") object_properties_.insert(s.subject);
    } else if (type == "owl:NamedIndividual" || type == "owl:Thing" || type.empty()) {
      declared_[kIndividual][s.subject] = true;
    }
  }

  void Mark(Role role, std::uint32_t term, std::uint32_t statement) {
    if (!index_.IsIri(term) || !index_.Word(term).empty()) return;
    std::uint32_t& use = uses_[role][term];
    if (use == Collector::kNone) use = statement;
  }

  void MarkList(Role role, std::uint32_t head, std::uint32_t statement) {
    const auto members = index_.List(head);
    if (!members) return;
    for (const std::uint32_t member : *members) Mark(role, member, statement);
  }

  void Use(std::uint32_t index) {
    const rdf::Statement& s = index_.Statement(index);
    const std::string_view word = index_.Word(s.predicate);
    if (word.empty()) return UseAssertion(index);
    if (word == "rdf:type") {
      Mark(kClass, s.object, index);
    } else if (word == "rdfs:subClassOf" || word == "owl:equivalentClass" ||
               word == "owl:disjointWith" || word == "owl:complementOf") {
      Mark(kClass, s.subject, index);
      Mark(kClass, s.object, index);
    } else if (word == "owl:someValuesFrom" || word == "owl:allValuesFrom" ||
               word == "owl:onClass") {
      Mark(kClass, s.object, index);
    } else if (word == "rdfs:domain" || word == "rdfs:range") {
      Mark(kProperty, s.subject, index);
      Mark(kClass, s.object, index);
    } else if (word == "rdfs:subPropertyOf" || word == "owl:inverseOf" ||
               word == "owl:equivalentProperty" || word == "owl:propertyDisjointWith") {
      Mark(kProperty, s.subject, index);
      Mark(kProperty, s.object, index);
    } else if (word == "owl:onProperty" || word == "owl:assertionProperty") {
      Mark(kProperty, s.object, index);
    } else if (word == "owl:unionOf" || word == "owl:intersectionOf" ||
               word == "owl:disjointUnionOf" ||
               (word == "owl:members" && index_.HasType(s.subject, "owl:AllDisjointClasses"))) {
      MarkList(kClass, s.object, index);
    } else if (word == "owl:propertyChainAxiom" || word == "owl:hasKey") {
      MarkList(kProperty, s.object, index);
    } else if (word == "owl:oneOf" || word == "owl:distinctMembers") {
      MarkList(kIndividual, s.object, index);
    } else if (word == "owl:sameAs" || word == "owl:differentFrom") {
      Mark(kIndividual, s.subject, index);
      Mark(kIndividual, s.object, index);
    }
  }

  // Values of annotations may be anything, so an individual is asked of object properties only.
  void UseAssertion(std::uint32_t index) {
    const rdf::Statement& s = index_.Statement(index);
    Mark(kProperty, s.predicate, index);
    if (!IsObjectProperty(s.predicate)) return;
    Mark(kIndividual, s.subject, index);
    Mark(kIndividual, s.object, index);
  }

  bool IsObjectProperty(std::uint32_t property) {
    if (object_properties_.count(property) != 0) return true;
    const auto [known, is_new] = in_catalogue_.emplace(property, false);
    if (is_new) known->second = HasCatalogueType(property, {"ObjectProperty"});
    return known->second;
  }

  std::optional<rdf::TermId> InCatalogue(std::uint32_t term) const {
    return catalogue_.dictionary().FindIri(aliases_.Canonical(index_.Term(term).value));
  }

  bool HasCatalogueType(std::uint32_t term, std::initializer_list<std::string_view> types) const {
    const auto id = InCatalogue(term);
    const auto type = catalogue_.dictionary().FindIri(std::string(rdf::kRdf) + "type");
    if (!id || !type) return false;
    for (const std::string_view name : types) {
      const auto word = catalogue_.dictionary().FindIri(std::string(rdf::kOwl) + std::string(name));
      if (word && catalogue_.Contains({*id, *type, *word})) return true;
    }
    return false;
  }

  bool IsDeclared(Role role, std::uint32_t term) const {
    if (declared_[role][term]) return true;
    if (role == kClass) {
      const auto id = InCatalogue(term);
      const auto sub = catalogue_.dictionary().FindIri(std::string(rdf::kRdfs) + "subClassOf");
      return HasCatalogueType(term, {"Class"}) ||
             (id && sub && !catalogue_.Objects(*id, *sub).empty());
    }
    if (role == kProperty) {
      return HasCatalogueType(term, {"ObjectProperty", "DatatypeProperty", "AnnotationProperty",
                                     "FunctionalProperty", "OntologyProperty"});
    }
    if (declared_[kClass][term] || declared_[kProperty][term]) return true;  // punning
    const auto id = InCatalogue(term);
    const auto type = catalogue_.dictionary().FindIri(std::string(rdf::kRdf) + "type");
    return id && type && !catalogue_.Objects(*id, *type).empty();
  }

  // Local names that are declared, for suggestions.
  const std::vector<std::string>& DeclaredNames(Role role) {
    std::vector<std::string>& names = names_[role];
    if (!names.empty()) return names;
    std::set<std::string> all;
    for (std::uint32_t term = 0; term < declared_[role].size(); ++term) {
      if (declared_[role][term] && index_.IsIri(term)) {
        all.emplace(LocalName(index_.Term(term).value));
      }
    }
    const auto type = catalogue_.dictionary().FindIri(std::string(rdf::kRdf) + "type");
    for (const std::string_view word :
         role == kClass ? std::vector<std::string_view>{"Class"}
                        : std::vector<std::string_view>{"ObjectProperty", "DatatypeProperty",
                                                        "AnnotationProperty"}) {
      const auto kind = catalogue_.dictionary().FindIri(std::string(rdf::kOwl) + std::string(word));
      if (!type || !kind || role == kIndividual) continue;
      for (const rdf::TermId id : catalogue_.Subjects(*type, *kind)) {
        const rdf::TermView named = catalogue_.dictionary().Get(id);
        if (named.kind == rdf::TermKind::kIri) all.emplace(LocalName(named.value));
      }
    }
    names.assign(all.begin(), all.end());
    return names;
  }

  void ReportRole(Role role) {
    std::size_t suggested = 0;
    for (std::uint32_t term = 0; term < uses_[role].size(); ++term) {
      const std::uint32_t use = uses_[role][term];
      if (use == Collector::kNone || IsDeclared(role, term)) continue;
      const std::string& iri = index_.Term(term).value;
      const std::string local(LocalName(iri));
      std::vector<std::string> similar;
      if (role != kIndividual && ++suggested <= kMostSuggested) {
        similar = SimilarNames(local, DeclaredNames(role), 3);
      }
      if (!similar.empty()) {
        found_.Add(Kind::kUndeclared,
                   "the " + std::string(kNames[role]) + " " + local +
                       " is declared nowhere; similar names: " + Join(similar, ", "),
                   use, term);
        continue;
      }
      const std::string space = iri.substr(0, iri.size() - local.size());
      found_.Add(Kind::kUndeclared,
                 std::string(kPlurals[role]) + " of <" + space +
                     "> that are declared nowhere in the document or the catalogue",
                 use, term);
    }
  }

  void ReportPunning() {
    for (std::uint32_t term = 0; term < declared_[kClass].size(); ++term) {
      if (!index_.IsIri(term)) continue;
      const int roles =
          declared_[kClass][term] + declared_[kProperty][term] + declared_[kIndividual][term];
      if (roles < 2) continue;
      std::string what;
      for (const Role role : {kClass, kProperty, kIndividual}) {
        if (declared_[role][term])
          what += (what.empty() ? "" : " and ") + std::string(kNames[role]);
      }
      found_.Add(Kind::kRemark,
                 "one name for a " + what + " (punning): each is reasoned about alone",
                 Collector::kNone, term);
    }
  }

  const DocumentIndex& index_;
  const rdf::View& catalogue_;
  const rdf::AliasTable& aliases_;
  Collector& found_;
  std::array<std::vector<std::uint32_t>, kRoles> uses_;  // by term: the first statement
  std::array<std::vector<bool>, kRoles> declared_;       // by term: in the document
  std::array<std::vector<std::string>, kRoles> names_;
  std::set<std::uint32_t> object_properties_;
  std::map<std::uint32_t, bool> in_catalogue_;  // object properties there
};

}  // namespace

void CheckDeclarations(const DocumentIndex& index, const rdf::View& catalogue,
                       const rdf::AliasTable& aliases, Collector& found) {
  DeclarationCheck(index, catalogue, aliases, found).Run();
}

}  // namespace lares::profile
