#include "reasoner/profile/expressions.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>

namespace lares::profile {
namespace {

// Where a class expression stands (Profiles, 4.2.3).
enum class Position { kSub, kSuper, kEquivalent };

constexpr int kDeepest = 200;

std::string Where(Position position) {
  switch (position) {
    case Position::kSub:
      return "on the side of the subclass";
    case Position::kSuper:
      return "on the side of the superclass";
    case Position::kEquivalent:
      return "as an equivalent class";
  }
  return "";
}

// What a construct costs in a position where RL has no place for it.
std::string Why(std::string_view construct, Position position) {
  if (construct == "owl:someValuesFrom" || construct == "owl:minCardinality" ||
      construct == "owl:minQualifiedCardinality" || construct == "owl:hasSelf") {
    if (position == Position::kSub) return "it does not make anything a member";
    return "nothing is concluded from it: OWL 2 RL invents no individuals";
  }
  if (construct == "owl:unionOf" || construct == "owl:oneOf") {
    return "which of them it is, is not concluded";
  }
  if (construct == "owl:cardinality" || construct == "owl:qualifiedCardinality") {
    return "write owl:maxCardinality where at most one is meant";
  }
  if (construct == "owl:maxCardinality" || construct == "owl:maxQualifiedCardinality") {
    return position == Position::kSuper ? "only 0 and 1 count"
                                        : "it does not make anything a member";
  }
  return "it does not make anything a member";
}

class ProfileCheck {
 public:
  ProfileCheck(const DocumentIndex& index, Collector& found) : index_(index), found_(found) {}

  void Run();

 private:
  // The axiom that is being looked at, for places and names.
  struct Axiom {
    std::uint32_t statement = 0;
    std::uint32_t subject = 0;
  };

  void CheckStatement(std::uint32_t index);
  void CheckClass(std::uint32_t term, Position position, Axiom axiom, int depth = 0);
  void CheckConstruct(std::uint32_t term, std::string_view construct, std::uint32_t value,
                      Position position, Axiom axiom, int depth);
  void CheckMembers(std::uint32_t head, Position position, Axiom axiom, int depth);
  void CheckRestriction(std::uint32_t term, std::string_view construct, std::uint32_t value,
                        Position position, Axiom axiom, int depth);
  void CheckDataRange(std::uint32_t term, Axiom axiom, int depth = 0);
  void CheckDatatype(std::uint32_t statement);
  bool IsDataRange(std::uint32_t term) const;
  bool IsAnnotation(std::uint32_t property) const;
  void Report(const std::string& message, Axiom axiom) {
    found_.Add(Kind::kProfile, message, axiom.statement, axiom.subject);
  }
  void Refuse(std::string_view construct, Position position, Axiom axiom) {
    Report(std::string(construct) + " " + Where(position) + ": " + Why(construct, position), axiom);
  }

  const DocumentIndex& index_;
  Collector& found_;
  std::set<std::pair<std::uint32_t, Position>> seen_;
  std::set<std::uint32_t> seen_ranges_;
};

bool ProfileCheck::IsDataRange(std::uint32_t term) const {
  return IsDatatypeWord(index_.Word(term)) || index_.HasType(term, "rdfs:Datatype") ||
         index_.HasType(term, "owl:DataRange");
}

bool ProfileCheck::IsAnnotation(std::uint32_t property) const {
  const std::string_view word = index_.Word(property);
  return !word.empty() || index_.HasType(property, "owl:AnnotationProperty");
}

void ProfileCheck::CheckMembers(std::uint32_t head, Position position, Axiom axiom, int depth) {
  const auto members = index_.List(head);
  if (!members) return;  // a fault of structure
  for (const std::uint32_t member : *members) CheckClass(member, position, axiom, depth + 1);
}

void ProfileCheck::CheckClass(std::uint32_t term, Position position, Axiom axiom, int depth) {
  if (depth > kDeepest || IsDataRange(term)) return;
  if (index_.Word(term) == "owl:Thing") {
    found_.Add(
        Kind::kRemark,
        "owl:Thing " + Where(position) + ": OWL 2 RL has no place for it, and it says nothing",
        axiom.statement, axiom.subject);
    return;
  }
  if (!index_.IsBlank(term) || !seen_.emplace(term, position).second) return;
  for (const std::uint32_t index : index_.About(term)) {
    const rdf::Statement& statement = index_.Statement(index);
    CheckConstruct(term, index_.Word(statement.predicate), statement.object, position,
                   {index, axiom.subject}, depth);
  }
}

void ProfileCheck::CheckConstruct(std::uint32_t term, std::string_view construct,
                                  std::uint32_t value, Position position, Axiom axiom, int depth) {
  if (construct == "owl:intersectionOf") {
    CheckMembers(value, position, axiom, depth);
  } else if (construct == "owl:unionOf") {
    if (position == Position::kSub) return CheckMembers(value, position, axiom, depth);
    Refuse(construct, position, axiom);
  } else if (construct == "owl:oneOf") {
    if (position != Position::kSub) Refuse(construct, position, axiom);
  } else if (construct == "owl:complementOf") {
    if (position == Position::kSuper) return CheckClass(value, Position::kSub, axiom, depth + 1);
    Refuse(construct, position, axiom);
  } else {
    CheckRestriction(term, construct, value, position, axiom, depth);
  }
}

void ProfileCheck::CheckRestriction(std::uint32_t term, std::string_view construct,
                                    std::uint32_t value, Position position, Axiom axiom,
                                    int depth) {
  static constexpr std::array<std::string_view, 9> kConstructs = {
      "owl:someValuesFrom",          "owl:allValuesFrom",        "owl:hasSelf",
      "owl:minCardinality",          "owl:maxCardinality",       "owl:cardinality",
      "owl:minQualifiedCardinality", "owl:qualifiedCardinality", "owl:maxQualifiedCardinality"};
  if (std::find(kConstructs.begin(), kConstructs.end(), construct) == kConstructs.end()) return;
  const auto check_filler = [&](std::uint32_t filler, Position where) {
    if (IsDataRange(filler)) return CheckDataRange(filler, axiom);
    if (index_.Word(filler) != "owl:Thing") CheckClass(filler, where, axiom, depth + 1);
  };
  if (construct == "owl:someValuesFrom" && position == Position::kSub) {
    return check_filler(value, Position::kSub);
  }
  if (construct == "owl:allValuesFrom" && position == Position::kSuper) {
    return check_filler(value, Position::kSuper);
  }
  const bool is_at_most = construct.starts_with("owl:max");
  const std::string& number = index_.Term(value).value;
  if (is_at_most && position == Position::kSuper && (number == "0" || number == "1")) {
    if (const auto filler = index_.Object(term, "owl:onClass")) {
      check_filler(*filler, Position::kSub);
    }
    if (const auto range = index_.Object(term, "owl:onDataRange")) CheckDataRange(*range, axiom);
    return;
  }
  Refuse(construct, position, axiom);
}

void ProfileCheck::CheckDataRange(std::uint32_t term, Axiom axiom, int depth) {
  const std::string_view word = index_.Word(term);
  if (!word.empty()) {
    if (!IsRlDatatype(word) && word != "rdfs:Datatype") {
      Report("the datatype " + std::string(word) +
                 " is none of OWL 2 RL's: its values are not "
                 "compared",
             axiom);
    }
    return;
  }
  if (!index_.IsBlank(term) || depth > kDeepest || !seen_ranges_.insert(term).second) return;
  for (const std::uint32_t index : index_.About(term)) {
    const rdf::Statement& statement = index_.Statement(index);
    const std::string_view construct = index_.Word(statement.predicate);
    if (construct == "owl:intersectionOf") {
      const auto members = index_.List(statement.object);
      if (!members) continue;
      for (const std::uint32_t member : *members) CheckDataRange(member, axiom, depth + 1);
    } else if (construct == "owl:unionOf" || construct == "owl:oneOf" ||
               construct == "owl:datatypeComplementOf" || construct == "owl:onDatatype") {
      Report(std::string(construct) +
                 " as a range of values: OWL 2 RL has datatypes and "
                 "owl:intersectionOf only",
             {index, axiom.subject});
    }
  }
}

void ProfileCheck::CheckDatatype(std::uint32_t index) {
  const rdf::Statement& statement = index_.Statement(index);
  const rdf::Term& object = index_.Term(statement.object);
  if (object.kind != rdf::TermKind::kLiteral || object.datatype.empty() ||
      IsAnnotation(statement.predicate)) {
    return;
  }
  constexpr std::string_view kXsd = "http://www.w3.org/2001/XMLSchema#";
  if (!object.datatype.starts_with(kXsd)) return;
  const std::string word = "xsd:" + object.datatype.substr(kXsd.size());
  if (IsRlDatatype(word)) return;
  Report("values of " + word + ", which is none of OWL 2 RL's datatypes: they are not compared",
         {index, statement.predicate});
}

void ProfileCheck::CheckStatement(std::uint32_t index) {
  const rdf::Statement& statement = index_.Statement(index);
  const std::string_view word = index_.Word(statement.predicate);
  const Axiom axiom{index, statement.subject};
  const std::uint32_t subject = statement.subject;
  const std::uint32_t object = statement.object;
  if (index_.IsLiteral(object)) return CheckDatatype(index);
  if (word == "rdfs:subClassOf") {
    CheckClass(subject, Position::kSub, axiom);
    CheckClass(object, Position::kSuper, axiom);
  } else if (word == "owl:equivalentClass") {
    if (index_.HasType(subject, "rdfs:Datatype")) return CheckDataRange(object, axiom);
    CheckClass(subject, Position::kEquivalent, axiom);
    CheckClass(object, Position::kEquivalent, axiom);
  } else if (word == "owl:disjointWith") {
    CheckClass(subject, Position::kSub, axiom);
    CheckClass(object, Position::kSub, axiom);
  } else if (word == "owl:members" && index_.HasType(subject, "owl:AllDisjointClasses")) {
    CheckMembers(object, Position::kSub, axiom, 0);
  } else if (word == "rdfs:domain") {
    CheckClass(object, Position::kSuper, axiom);
  } else if (word == "rdfs:range") {
    if (IsDataRange(object)) return CheckDataRange(object, axiom);
    CheckClass(object, Position::kSuper, axiom);
  } else if (word == "owl:hasKey") {
    CheckClass(subject, Position::kSub, axiom);
  } else if (word == "owl:disjointUnionOf") {
    Report(
        "owl:disjointUnionOf: OWL 2 RL has no disjoint unions; say subclasses and "
        "owl:AllDisjointClasses",
        axiom);
  } else if (word == "rdf:type") {
    const std::string_view type = index_.Word(object);
    if (type == "owl:ReflexiveProperty") {
      Report("owl:ReflexiveProperty: OWL 2 RL has no reflexive properties", axiom);
    } else if (index_.IsBlank(object)) {
      CheckClass(object, Position::kSuper, axiom);
    }
  } else if (index_.IsIri(subject) && !index_.HasType(subject, "rdfs:Datatype") &&
             (word == "owl:unionOf" || word == "owl:intersectionOf" || word == "owl:oneOf" ||
              word == "owl:complementOf")) {
    // A named class described in place: the same as an equivalent class.
    CheckConstruct(subject, word, object, Position::kEquivalent, axiom, 0);
  }
}

void ProfileCheck::Run() {
  const auto count = static_cast<std::uint32_t>(index_.document().statements.size());
  for (std::uint32_t i = 0; i < count; ++i) CheckStatement(i);
}

}  // namespace

void CheckProfile(const DocumentIndex& index, Collector& found) {
  ProfileCheck(index, found).Run();
}

}  // namespace lares::profile
