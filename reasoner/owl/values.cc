#include "reasoner/owl/values.h"

#include <string>

#include "ontology/rdf/literal_value.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {
namespace {

class Question {
 public:
  explicit Question(const rdf::View& view) : view_(view), words_(view.dictionary()) {}

  bool Ask() const {
    return view_.has_literal_subjects() || UsesDatatypesAsClasses() ||
           (view_.dictionary().has_twins() && ComparesLiterals());
  }

 private:
  rdf::TermId Word(std::string_view name) const {
    return view_.dictionary().InternIri(Expand(name));
  }
  bool Has(const rdf::Pattern& pattern) const { return view_.Estimate(pattern) > 0; }

  bool UsesDatatypesAsClasses() const {
    for (const std::string_view iri : rdf::SupportedDatatypes()) {
      const auto datatype = view_.dictionary().FindIri(iri);
      if (!datatype) continue;
      for (const char* axiom : {"rdfs:subClassOf", "owl:equivalentClass", "owl:disjointWith"}) {
        if (Has({*datatype, Word(axiom), {}})) return true;
      }
      for (const char* part : {"owl:someValuesFrom", "owl:onClass", "owl:complementOf",
                               "owl:equivalentClass", "owl:disjointWith", "rdf:first"}) {
        if (Has({{}, Word(part), *datatype})) return true;
      }
    }
    return false;
  }

  bool ComparesLiterals() const {
    for (const char* axiom : {"owl:hasKey", "owl:propertyDisjointWith", "owl:targetValue"}) {
      if (Has({{}, Word(axiom), {}})) return true;
    }
    for (const char* kind : {"owl:AllDisjointProperties", "owl:InverseFunctionalProperty"}) {
      if (Has({{}, words_.type, Word(kind)})) return true;
    }
    return !view_.ForEach({{}, Word("owl:hasValue"), {}}, [&](const rdf::Triple& triple) {
      return view_.dictionary().Kind(triple.object) != rdf::TermKind::kLiteral;
    });
  }

  const rdf::View& view_;
  const Vocabulary words_;
};

}  // namespace

bool DependsOnValues(const rdf::View& view) { return Question(view).Ask(); }

}  // namespace lares::owl
