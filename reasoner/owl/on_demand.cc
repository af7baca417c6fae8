#include "reasoner/owl/on_demand.h"

#include <algorithm>
#include <string>
#include <vector>

#include "ontology/rdf/literal_value.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {
namespace {

using rdf::TermId;
using rdf::Triple;

class Question {
 public:
  explicit Question(const rdf::View& view)
      : view_(view), dictionary_(view.dictionary()), words_(dictionary_) {}

  std::optional<Reason> Ask(const Triple& triple) const {
    if (Contains(triple)) return Reason{};
    if (const auto* rule = TrivialRule(triple)) return Reason{rule};
    if (const auto* rule = DatatypeRule(triple)) return Reason{rule};
    return std::nullopt;
  }

  std::optional<Reason> AskAlone(const Triple& triple) const {
    const auto [s, p, o] = triple;
    if (p == words_.type) {
      for (const AxiomRow& row : AxiomTable()) {
        if (Word(row.subject) == s && Word(row.object) == o) return Reason{row.name};
      }
      const std::string_view name = dictionary_.Get(s).value;
      if (o == Word("rdfs:Datatype")) {
        return !IsLiteral(s) && rdf::IsSupportedDatatype(name) ? std::optional(Reason{"dt-type1"})
                                                               : std::nullopt;
      }
      const auto value = IsLiteral(s) ? rdf::ValueOf(dictionary_.Get(s)) : std::nullopt;
      const bool is_in = value && rdf::IsInDatatype(*value, dictionary_.Get(o).value);
      return is_in ? std::optional(Reason{"dt-type2"}) : std::nullopt;
    }
    if (p == words_.same_as && s == o) return Reason{"eq-ref"};
    if (IsLiteral(s) != IsLiteral(o)) return std::nullopt;
    if (!IsLiteral(s)) {
      const bool is_trivial =
          s == o || (p == words_.sub_class_of && (o == words_.thing || s == words_.nothing));
      const auto* rule = is_trivial ? TrivialRule(triple) : nullptr;
      return rule == nullptr ? std::nullopt : std::optional(Reason{rule});
    }
    if (p == words_.same_as && dictionary_.SameValue(s) == dictionary_.SameValue(o)) {
      return Reason{"dt-eq"};
    }
    if (p != Word("owl:differentFrom")) return std::nullopt;
    const auto first = rdf::ValueOf(dictionary_.Get(s)), second = rdf::ValueOf(dictionary_.Get(o));
    const bool differ = first && second && *first != *second;
    return differ ? std::optional(Reason{"dt-diff"}) : std::nullopt;
  }

 private:
  TermId Word(std::string_view name) const { return dictionary_.InternIri(Expand(name)); }
  bool IsLiteral(TermId term) const { return dictionary_.Kind(term) == rdf::TermKind::kLiteral; }
  TermId Representative(TermId term) const {
    return view_.equality() == nullptr ? term : view_.equality()->Representative(term);
  }
  bool Contains(const Triple& triple) const {
    if (!IsLiteral(triple.subject)) return view_.Contains(triple);
    return view_.ContainsStored({Representative(triple.subject), Representative(triple.predicate),
                                 Representative(triple.object)});
  }
  bool IsA(TermId term, std::string_view type) const {
    const Triple triple{term, words_.type, Word(type)};
    return view_.Contains(triple) || IsIn(AxiomTable(), triple);
  }

  template <typename Rows>
  const AxiomRow* Find(const Rows& rows, const Triple& triple) const {
    if (triple.predicate != words_.type) return nullptr;
    for (const AxiomRow& row : rows) {
      if (Representative(Word(row.subject)) == Representative(triple.subject) &&
          Representative(Word(row.object)) == Representative(triple.object)) {
        return &row;
      }
    }
    return nullptr;
  }
  template <typename Rows>
  bool IsIn(const Rows& rows, const Triple& triple) const {
    return Find(rows, triple) != nullptr;
  }

  // Rows whose conclusions are reflexive or have no premises.
  const char* TrivialRule(const Triple& triple) const {
    const auto [s, p, o] = triple;
    if (p == words_.same_as && Representative(s) == Representative(o)) return "eq-ref";
    if (const AxiomRow* row = Find(AxiomTable(), triple)) return row->name;
    if (p == words_.type && o == words_.thing) return "scm-cls";
    const bool is_reflexive = s == o || Representative(s) == Representative(o);
    if (p == words_.sub_class_of) {
      if (!is_reflexive && o != words_.thing && s != words_.nothing) return nullptr;
      return IsA(s == words_.nothing ? o : s, "owl:Class") ? "scm-cls" : nullptr;
    }
    if (!is_reflexive) return nullptr;
    if (p == words_.equivalent_class) return IsA(s, "owl:Class") ? "scm-cls" : nullptr;
    if (p != words_.sub_property_of && p != words_.equivalent_property) return nullptr;
    if (IsA(s, "owl:ObjectProperty")) return "scm-op";
    return IsA(s, "owl:DatatypeProperty") ? "scm-dp" : nullptr;
  }

  // Table 8, and eq-rep-o by what it says.
  const char* DatatypeRule(const Triple& triple) const {
    const auto [s, p, o] = triple;
    if (p == words_.type) {
      const std::string_view type = dictionary_.Get(o).value;
      if (o == Word("rdfs:Datatype") && rdf::IsSupportedDatatype(dictionary_.Get(s).value)) {
        return "dt-type1";
      }
      if (!rdf::IsSupportedDatatype(type)) return nullptr;
      for (const rdf::DataValue& value : ValuesOf(s)) {
        if (rdf::IsInDatatype(value, type)) return "dt-type2";
      }
      return nullptr;
    }
    if (IsLiteral(s) && IsLiteral(o) && p == words_.same_as &&
        dictionary_.SameValue(s) == dictionary_.SameValue(o)) {
      return "dt-eq";
    }
    if (p == Word("owl:differentFrom") && AreDifferentValues(s, o)) return "dt-diff";
    for (const TermId twin : dictionary_.ValueTwins(o)) {
      if (view_.Contains({s, p, twin})) return "dt-eq";
    }
    return nullptr;
  }

  bool AreDifferentValues(TermId a, TermId b) const {
    for (const rdf::DataValue& first : ValuesOf(a)) {
      for (const rdf::DataValue& second : ValuesOf(b)) {
        if (first != second) return true;
      }
    }
    return false;
  }

  // Of a literal, or of the literals that a term is the same as.
  std::vector<rdf::DataValue> ValuesOf(TermId term) const {
    std::vector<rdf::DataValue> values;
    const auto add = [&](TermId each) {
      if (!IsLiteral(each)) return;
      if (auto value = rdf::ValueOf(dictionary_.Get(each))) values.push_back(std::move(*value));
    };
    add(term);
    if (view_.equality() == nullptr) return values;
    for (const TermId member : view_.equality()->Members(Representative(term))) add(member);
    return values;
  }

  const rdf::View& view_;
  rdf::Dictionary& dictionary_;
  Vocabulary words_;
};

}  // namespace

std::optional<Reason> Holds(const rdf::View& view, const rdf::Triple& triple) {
  return Question(view).Ask(triple);
}

std::optional<Reason> HoldsByItself(const rdf::View& view, const rdf::Triple& triple) {
  return Question(view).AskAlone(triple);
}

bool IsOutsideDatatype(const rdf::TermView& literal, std::string_view datatype) {
  const auto value = rdf::ValueOf(literal);
  return value ? !rdf::IsInDatatype(*value, datatype) : rdf::IsSupportedDatatype(literal.datatype);
}

}  // namespace lares::owl
