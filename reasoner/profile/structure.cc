#include "reasoner/profile/structure.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/text.h"

namespace lares::profile {
namespace {

constexpr std::string_view kFillers[] = {"owl:someValuesFrom",
                                         "owl:allValuesFrom",
                                         "owl:hasValue",
                                         "owl:hasSelf",
                                         "owl:minCardinality",
                                         "owl:maxCardinality",
                                         "owl:cardinality",
                                         "owl:minQualifiedCardinality",
                                         "owl:maxQualifiedCardinality",
                                         "owl:qualifiedCardinality"};

bool IsFiller(std::string_view word) {
  return std::find(std::begin(kFillers), std::end(kFillers), word) != std::end(kFillers);
}

bool HoldsList(std::string_view word) {
  static const std::set<std::string_view> kWords = {
      "owl:intersectionOf",  "owl:unionOf",         "owl:oneOf",           "owl:members",
      "owl:distinctMembers", "owl:hasKey",          "owl:disjointUnionOf", "owl:propertyChainAxiom",
      "owl:onProperties",    "owl:withRestrictions"};
  return kWords.count(word) != 0;
}

bool IsNatural(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

class StructureCheck {
 public:
  StructureCheck(const DocumentIndex& index, Collector& found) : index_(index), found_(found) {}

  void Run() {
    const auto terms = static_cast<std::uint32_t>(index_.document().terms.size());
    for (std::uint32_t term = 0; term < terms; ++term) {
      if (!index_.About(term).empty()) CheckNode(term);
      CheckWord(term);
    }
    const auto count = static_cast<std::uint32_t>(index_.document().statements.size());
    for (std::uint32_t i = 0; i < count; ++i) CheckStatement(i);
  }

 private:
  void Report(const std::string& message, std::uint32_t statement, std::uint32_t term) {
    found_.Add(Kind::kStructure, message, statement, term);
  }

  void CheckWord(std::uint32_t term) {
    const std::string_view word = index_.Word(term);
    if (word.empty() || word.ends_with(':') || IsKnownWord(word)) return;
    std::string message = std::string(word) + " is no word of its vocabulary";
    const auto similar = SimilarNames(word, KnownWords(), 1);
    if (!similar.empty()) message += "; perhaps " + similar.front() + " is meant";
    found_.Add(Kind::kUndeclared, message, Collector::kNone, term);
  }

  void CheckNode(std::uint32_t term) {
    const std::uint32_t first = index_.About(term).front();
    CheckRestriction(term, first);
    CheckCell(term, first);
    const auto need = [&](std::string_view type, std::initializer_list<std::string_view> parts) {
      if (!index_.HasType(term, type)) return;
      for (const std::string_view part : parts) {
        if (index_.Object(term, part)) return;
      }
      Report(std::string(type) + " without " + std::string(*parts.begin()), first, term);
    };
    need("owl:AllDisjointClasses", {"owl:members"});
    need("owl:AllDisjointProperties", {"owl:members"});
    need("owl:AllDifferent", {"owl:distinctMembers", "owl:members"});
    need("owl:NegativePropertyAssertion", {"owl:sourceIndividual"});
    need("owl:NegativePropertyAssertion", {"owl:assertionProperty"});
    need("owl:NegativePropertyAssertion", {"owl:targetIndividual", "owl:targetValue"});
    need("owl:Axiom", {"owl:annotatedSource"});
    need("owl:Axiom", {"owl:annotatedProperty"});
    need("owl:Axiom", {"owl:annotatedTarget"});
    const bool is_both =
        index_.HasType(term, "owl:ObjectProperty") && index_.HasType(term, "owl:DatatypeProperty");
    if (is_both) Report("both an object and a data property", first, term);
    if (index_.HasType(term, "owl:Class") && index_.HasType(term, "rdfs:Datatype")) {
      Report("both a class and a datatype", first, term);
    }
  }

  void CheckRestriction(std::uint32_t term, std::uint32_t first) {
    const auto properties = index_.About(term, "owl:onProperty");
    const bool has_several = !index_.About(term, "owl:onProperties").empty();
    std::size_t fillers = 0;
    for (const std::uint32_t index : index_.About(term)) {
      fillers += IsFiller(index_.Word(index_.Statement(index).predicate)) ? 1 : 0;
    }
    const bool is_restriction = index_.HasType(term, "owl:Restriction");
    if (!is_restriction && fillers == 0 && properties.empty()) return;
    if (properties.empty() && !has_several) {
      return Report("a restriction without owl:onProperty means nothing", first, term);
    }
    if (properties.size() > 1) {
      Report("a restriction with several owl:onProperty", properties[1], term);
    }
    if (fillers == 0) Report("a restriction that restricts nothing", first, term);
    if (fillers > 1) {
      Report("a restriction with several constraints: write one restriction for each", first, term);
    }
    if (!is_restriction) Report("a restriction that is not typed owl:Restriction", first, term);
  }

  void CheckCell(std::uint32_t term, std::uint32_t first_statement) {
    const auto firsts = index_.About(term, "rdf:first");
    const auto rests = index_.About(term, "rdf:rest");
    if (firsts.empty() && rests.empty()) return;
    if (index_.Word(term) == "rdf:nil") {
      Report("rdf:nil, the empty list, is given members", first_statement, term);
    } else if (firsts.size() != 1) {
      Report(
          firsts.empty() ? "a list cell without rdf:first" : "a list cell with several rdf:first",
          first_statement, term);
    } else if (rests.size() != 1) {
      Report(rests.empty() ? "a list that does not end: a cell without rdf:rest"
                           : "a list that forks: a cell with several rdf:rest",
             first_statement, term);
    }
  }

  void CheckStatement(std::uint32_t index) {
    const rdf::Statement& statement = index_.Statement(index);
    const std::string_view word = index_.Word(statement.predicate);
    const std::uint32_t object = statement.object;
    if (HoldsList(word) && !index_.List(object)) {
      return Report(std::string(word) +
                        " with a list that is malformed or runs in a circle: the "
                        "axiom is not used",
                    index, statement.subject);
    }
    if (word.ends_with("ardinality") && !IsNatural(index_.Term(object).value)) {
      return Report(std::string(word) + " is no number from 0", index, statement.subject);
    }
    if ((word == "rdfs:subClassOf" || word == "owl:equivalentClass" || word == "rdfs:domain" ||
         word == "rdfs:range" || word == "owl:disjointWith" || word == "rdfs:subPropertyOf" ||
         word == "rdf:type" || word == "owl:onProperty" || word == "owl:inverseOf") &&
        index_.IsLiteral(object)) {
      return Report(std::string(word) + " leads to a text where a class or property belongs", index,
                    statement.subject);
    }
    const bool is_class_place = word == "rdfs:subClassOf" || word == "owl:equivalentClass" ||
                                word == "owl:complementOf" || word == "owl:disjointWith";
    if (is_class_place && index_.IsBlank(object) && index_.About(object).empty()) {
      Report("an unnamed class that nothing describes", index, statement.subject);
    }
    if (is_class_place && object == statement.subject && word != "owl:equivalentClass" &&
        index_.IsBlank(object)) {
      Report("an unnamed class that is described by itself", index, statement.subject);
    }
  }

  const DocumentIndex& index_;
  Collector& found_;
};

}  // namespace

void CheckStructure(const DocumentIndex& index, Collector& found) {
  StructureCheck(index, found).Run();
}

}  // namespace lares::profile
