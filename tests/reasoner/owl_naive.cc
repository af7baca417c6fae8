#include "tests/reasoner/owl_naive.h"

#include <functional>
#include <map>
#include <vector>

#include "ontology/rdf/literal_value.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::testing {
namespace {

using rdf::TermId;
using rdf::Triple;
using Ids = std::vector<TermId>;
using Pairs = std::vector<std::pair<TermId, TermId>>;

class Naive {
 public:
  Naive(std::set<Triple> triples, rdf::Dictionary& dictionary) : dictionary_(dictionary) {
    for (const Triple& t : triples) {
      result_.triples.insert({t.subject, t.predicate, dictionary.SameValue(t.object)});
    }
  }

  NaiveClosure Run() {
    std::size_t before = 0;
    while (before != result_.triples.size()) {
      before = result_.triples.size();
      Datatypes();
      by_predicate_.clear();
      for (const Triple& t : result_.triples) {
        by_predicate_[t.predicate].emplace_back(t.subject, t.object);
      }
      Equality();
      Properties();
      PropertyLists();
      Classes();
      Cardinalities();
      ClassAxioms();
      SchemaOfClasses();
      SchemaOfProperties();
      SchemaOfRestrictions();
    }
    result_.triples = ComparableTriples(result_.triples, dictionary_);
    return std::move(result_);
  }

 private:
  TermId Owl(const char* name) { return dictionary_.InternIri(std::string(rdf::kOwl) + name); }
  TermId Rdfs(const char* name) { return dictionary_.InternIri(std::string(rdf::kRdfs) + name); }
  TermId Rdf(const char* name) { return dictionary_.InternIri(std::string(rdf::kRdf) + name); }
  TermId Type() { return Rdf("type"); }
  TermId Same() { return Owl("sameAs"); }
  TermId Sub() { return Rdfs("subClassOf"); }
  TermId SubProperty() { return Rdfs("subPropertyOf"); }

  const Pairs& Of(TermId p) { return by_predicate_[p]; }
  Ids Values(TermId s, TermId p) {
    Ids values;
    for (const auto& [x, y] : Of(p)) {
      if (x == s) values.push_back(y);
    }
    return values;
  }
  Ids Members(TermId type) {
    Ids members;
    for (const auto& [x, c] : Of(Type())) {
      if (c == type) members.push_back(x);
    }
    return members;
  }
  bool Has(TermId s, TermId p, TermId o) { return result_.triples.contains({s, p, o}); }
  bool IsLiteral(TermId id) { return dictionary_.Get(id).kind == rdf::TermKind::kLiteral; }
  bool IsNumber(TermId id, const char* value) {
    const auto known = rdf::ValueOf(dictionary_.Get(id));
    return IsLiteral(id) && known && known->canonical == value;
  }

  void Add(TermId s, TermId p, TermId o) {
    if (IsLiteral(p)) return;
    if (p == Same() && (s == o || AreDifferentValues(s, o))) return;
    if (p == Type() && o == Owl("Thing")) return;
    if (p == Sub() && (o == Owl("Thing") || s == Owl("Nothing"))) return;
    result_.triples.insert({s, p, o});
  }
  // Never made the same: the contradiction, if that is said of two known values.
  bool AreDifferentValues(TermId a, TermId b) {
    if (!IsLiteral(a) || !IsLiteral(b)) return false;
    const auto first = rdf::ValueOf(dictionary_.Get(a)), second = rdf::ValueOf(dictionary_.Get(b));
    if (first && second && *first != *second) Clash("eq-diff1");
    return first != second;
  }
  void Clash(const char* rule) { result_.clashes.insert(rule); }

  std::vector<Ids> Lists(TermId head, int depth = 0) {
    if (head == Rdf("nil")) return {{}};
    std::vector<Ids> lists;
    if (depth > 8) return lists;
    for (const TermId rest : Values(head, Rdf("rest"))) {
      for (Ids tail : Lists(rest, depth + 1)) {
        for (const TermId first : Values(head, Rdf("first"))) {
          Ids list = {first};
          list.insert(list.end(), tail.begin(), tail.end());
          lists.push_back(list);
        }
      }
    }
    return lists;
  }
  void ForLists(const char* predicate, const std::function<void(TermId, const Ids&)>& visit) {
    for (const auto& [c, l] : Pairs(Of(Owl(predicate)))) {
      for (const Ids& list : Lists(l)) visit(c, list);
    }
  }

  // Table 8. Literals are their values already.
  void Datatypes() {
    std::set<TermId> literals;
    for (const Triple& t : result_.triples) {
      if (IsLiteral(t.subject)) literals.insert(t.subject);
      if (IsLiteral(t.object)) literals.insert(t.object);
    }
    for (const TermId literal : literals) {
      const auto value = rdf::ValueOf(dictionary_.Get(literal));
      for (const std::string_view iri : rdf::SupportedDatatypes()) {
        const TermId datatype = dictionary_.InternIri(iri);
        const bool is_member = value && rdf::IsInDatatype(*value, iri);
        if (is_member) Add(literal, Type(), datatype);
        if (is_member || !Has(literal, Type(), datatype)) continue;
        if (value || rdf::IsSupportedDatatype(dictionary_.Get(literal).datatype)) {
          Clash("dt-not-type");
        }
      }
    }
  }

  void Equality() {
    for (const auto& [x, y] : Pairs(Of(Same()))) {
      Add(y, Same(), x);
      for (const TermId z : Values(y, Same())) Add(x, Same(), z);
      if (Has(x, Owl("differentFrom"), y)) Clash("eq-diff1");
      // Of a class or property that has two names.
      if (Has(x, Type(), Owl("Class"))) {
        Add(x, Sub(), y);
        Add(x, Owl("equivalentClass"), y);
      }
      if (Has(x, Type(), Owl("ObjectProperty")) || Has(x, Type(), Owl("DatatypeProperty"))) {
        Add(x, SubProperty(), y);
        Add(x, Owl("equivalentProperty"), y);
      }
      for (const Triple& t : std::set<Triple>(result_.triples)) {
        if (t.subject == x) Add(y, t.predicate, t.object);
        if (t.predicate == x) Add(t.subject, y, t.object);
        if (t.object == x) Add(t.subject, t.predicate, y);
      }
    }
    for (const auto& [x, y] : Of(Owl("differentFrom"))) {
      if (x == y) Clash("eq-diff1");
    }
    Different("members", "eq-diff2");
    Different("distinctMembers", "eq-diff3");
  }

  void Different(const char* predicate, const char* rule) {
    ForLists(predicate, [&](TermId a, const Ids& list) {
      if (!Has(a, Type(), Owl("AllDifferent"))) return;
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t j = i + 1; j < list.size(); ++j) {
          if (list[i] == list[j] || Has(list[i], Same(), list[j])) Clash(rule);
        }
      }
    });
  }

  void Properties() {
    for (const auto& [p, c] : Pairs(Of(Rdfs("domain")))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(x, Type(), c);
    }
    for (const auto& [p, c] : Pairs(Of(Rdfs("range")))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(y, Type(), c);
    }
    for (const TermId p : Members(Owl("FunctionalProperty"))) {
      for (const auto& [x, y] : Pairs(Of(p))) {
        for (const TermId z : Values(x, p)) Add(y, Same(), z);
      }
    }
    for (const TermId p : Members(Owl("InverseFunctionalProperty"))) {
      for (const auto& [x, y] : Pairs(Of(p))) {
        for (const auto& [z, w] : Pairs(Of(p))) {
          if (y == w) Add(x, Same(), z);
        }
      }
    }
    for (const TermId p : Members(Owl("IrreflexiveProperty"))) {
      for (const auto& [x, y] : Of(p)) {
        if (x == y) Clash("prp-irp");
      }
    }
    for (const TermId p : Members(Owl("SymmetricProperty"))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(y, p, x);
    }
    for (const TermId p : Members(Owl("AsymmetricProperty"))) {
      for (const auto& [x, y] : Of(p)) {
        if (Has(y, p, x)) Clash("prp-asyp");
      }
    }
    for (const TermId p : Members(Owl("TransitiveProperty"))) {
      for (const auto& [x, y] : Pairs(Of(p))) {
        for (const TermId z : Values(y, p)) Add(x, p, z);
      }
    }
    for (const auto& [p, q] : Pairs(Of(SubProperty()))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(x, q, y);
    }
    for (const auto& [p, q] : Pairs(Of(Owl("equivalentProperty")))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(x, q, y);
      for (const auto& [x, y] : Pairs(Of(q))) Add(x, p, y);
    }
    for (const auto& [p, q] : Pairs(Of(Owl("inverseOf")))) {
      for (const auto& [x, y] : Pairs(Of(p))) Add(y, q, x);
      for (const auto& [x, y] : Pairs(Of(q))) Add(y, p, x);
    }
    for (const auto& [p, q] : Pairs(Of(Owl("propertyDisjointWith")))) {
      for (const auto& [x, y] : Pairs(Of(p))) {
        if (Has(x, q, y)) Clash("prp-pdw");
      }
    }
    for (const auto& [n, i] : Pairs(Of(Owl("sourceIndividual")))) {
      for (const TermId p : Values(n, Owl("assertionProperty"))) {
        for (const TermId j : Values(n, Owl("targetIndividual"))) {
          if (Has(i, p, j)) Clash("prp-npa1");
        }
        for (const TermId j : Values(n, Owl("targetValue"))) {
          if (Has(i, p, j)) Clash("prp-npa2");
        }
      }
    }
  }

  void PropertyLists() {
    ForLists("propertyChainAxiom", [&](TermId p, const Ids& list) {
      if (list.empty()) return;
      Pairs reached = Of(list[0]);
      for (std::size_t i = 1; i < list.size(); ++i) {
        Pairs further;
        for (const auto& [x, y] : reached) {
          for (const TermId z : Values(y, list[i])) further.emplace_back(x, z);
        }
        reached = further;
      }
      for (const auto& [x, y] : reached) Add(x, p, y);
    });
    ForLists("hasKey", [&](TermId c, const Ids& list) {
      if (list.empty()) return;
      for (const TermId x : Members(c)) {
        for (const TermId y : Members(c)) {
          bool agree = true;
          for (const TermId p : list) {
            bool shared = false;
            for (const TermId z : Values(x, p)) shared = shared || Has(y, p, z);
            agree = agree && shared;
          }
          if (agree) Add(x, Same(), y);
        }
      }
    });
    ForLists("members", [&](TermId a, const Ids& list) {
      if (!Has(a, Type(), Owl("AllDisjointProperties"))) return;
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t j = i + 1; j < list.size(); ++j) {
          for (const auto& [x, y] : Pairs(Of(list[i]))) {
            if (Has(x, list[j], y)) Clash("prp-adp");
          }
        }
      }
    });
  }

  void Classes() {
    if (!Members(Owl("Nothing")).empty()) Clash("cls-nothing2");
    ForLists("intersectionOf", [&](TermId c, const Ids& list) {
      if (list.empty()) return;
      for (const TermId x : Members(list[0])) {
        bool in_all = true;
        for (const TermId d : list) in_all = in_all && Has(x, Type(), d);
        if (in_all) Add(x, Type(), c);
      }
      for (const TermId d : list) {
        for (const TermId x : Members(c)) Add(x, Type(), d);
        Add(c, Sub(), d);
      }
    });
    ForLists("unionOf", [&](TermId c, const Ids& list) {
      for (const TermId d : list) {
        for (const TermId x : Members(d)) Add(x, Type(), c);
        Add(d, Sub(), c);
      }
    });
    ForLists("oneOf", [&](TermId c, const Ids& list) {
      for (const TermId x : list) Add(x, Type(), c);
    });
    for (const auto& [c, d] : Of(Owl("complementOf"))) {
      for (const TermId x : Members(c)) {
        if (Has(x, Type(), d)) Clash("cls-com");
      }
    }
    for (const auto& [r, p] : Pairs(Of(Owl("onProperty")))) {
      for (const TermId c : Values(r, Owl("someValuesFrom"))) {
        for (const auto& [u, v] : Pairs(Of(p))) {
          if (c == Owl("Thing") || Has(v, Type(), c)) Add(u, Type(), r);
        }
      }
      for (const TermId c : Values(r, Owl("allValuesFrom"))) {
        for (const TermId u : Members(r)) {
          for (const TermId v : Values(u, p)) Add(v, Type(), c);
        }
      }
      for (const TermId value : Values(r, Owl("hasValue"))) {
        for (const TermId u : Members(r)) Add(u, p, value);
        for (const auto& [u, v] : Pairs(Of(p))) {
          if (v == value) Add(u, Type(), r);
        }
      }
    }
  }

  void Cardinalities() {
    for (const auto& [r, p] : Pairs(Of(Owl("onProperty")))) {
      for (const TermId n : Values(r, Owl("maxCardinality"))) {
        for (const TermId u : Members(r)) AtMost(n, Values(u, p), "cls-maxc1");
      }
      for (const TermId n : Values(r, Owl("maxQualifiedCardinality"))) {
        for (const TermId c : Values(r, Owl("onClass"))) {
          for (const TermId u : Members(r)) {
            if (c == Owl("Thing")) AtMost(n, Values(u, p), "cls-maxqc2");
            Ids typed;
            for (const TermId v : Values(u, p)) {
              if (Has(v, Type(), c)) typed.push_back(v);
            }
            AtMost(n, typed, "cls-maxqc1");
          }
        }
      }
    }
  }

  void AtMost(TermId number, const Ids& values, const char* rule_of_none) {
    if (IsNumber(number, "0") && !values.empty()) Clash(rule_of_none);
    if (!IsNumber(number, "1")) return;
    for (const TermId y : values) {
      for (const TermId z : values) Add(y, Same(), z);
    }
  }

  void ClassAxioms() {
    for (const auto& [c, d] : Pairs(Of(Sub()))) {
      for (const TermId x : Members(c)) Add(x, Type(), d);
    }
    for (const auto& [c, d] : Pairs(Of(Owl("equivalentClass")))) {
      for (const TermId x : Members(c)) Add(x, Type(), d);
      for (const TermId x : Members(d)) Add(x, Type(), c);
    }
    for (const auto& [c, d] : Of(Owl("disjointWith"))) {
      for (const TermId x : Members(c)) {
        if (Has(x, Type(), d)) Clash("cax-dw");
      }
    }
    ForLists("members", [&](TermId a, const Ids& list) {
      if (!Has(a, Type(), Owl("AllDisjointClasses"))) return;
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t j = i + 1; j < list.size(); ++j) {
          for (const TermId x : Members(list[i])) {
            if (Has(x, Type(), list[j])) Clash("cax-adc");
          }
        }
      }
    });
  }

  void SchemaOfClasses() {
    for (const auto& [c, d] : Pairs(Of(Sub()))) {
      for (const TermId e : Values(d, Sub())) Add(c, Sub(), e);
      if (Has(d, Sub(), c)) Add(c, Owl("equivalentClass"), d);
    }
    for (const auto& [c, d] : Pairs(Of(Owl("equivalentClass")))) {
      Add(c, Sub(), d);
      Add(d, Sub(), c);
    }
  }

  void SchemaOfProperties() {
    for (const auto& [p, q] : Pairs(Of(SubProperty()))) {
      for (const TermId r : Values(q, SubProperty())) Add(p, SubProperty(), r);
      if (Has(q, SubProperty(), p)) Add(p, Owl("equivalentProperty"), q);
      for (const char* end : {"domain", "range"}) {
        for (const TermId c : Values(q, Rdfs(end))) Add(p, Rdfs(end), c);
      }
    }
    for (const auto& [p, q] : Pairs(Of(Owl("equivalentProperty")))) {
      Add(p, SubProperty(), q);
      Add(q, SubProperty(), p);
    }
    for (const char* end : {"domain", "range"}) {
      for (const auto& [p, c] : Pairs(Of(Rdfs(end)))) {
        for (const TermId d : Values(c, Sub())) Add(p, Rdfs(end), d);
      }
    }
  }

  void SchemaOfRestrictions() {
    const auto below_or_same = [&](TermId a, TermId property, TermId b) {
      return a == b || Has(a, property, b);
    };
    const Pairs on = Of(Owl("onProperty"));
    for (const auto& [c, p] : on) {
      for (const auto& [d, q] : on) {
        const bool sub = below_or_same(p, SubProperty(), q);
        for (const TermId y : Values(c, Owl("hasValue"))) {
          if (sub && Has(d, Owl("hasValue"), y)) Add(c, Sub(), d);
        }
        for (const TermId y : Values(c, Owl("someValuesFrom"))) {
          for (const TermId z : Values(d, Owl("someValuesFrom"))) {
            if (p == q && below_or_same(y, Sub(), z)) Add(c, Sub(), d);
            if (sub && y == z) Add(c, Sub(), d);
          }
        }
        for (const TermId y : Values(c, Owl("allValuesFrom"))) {
          for (const TermId z : Values(d, Owl("allValuesFrom"))) {
            if (p == q && below_or_same(y, Sub(), z)) Add(c, Sub(), d);
            if (sub && y == z) Add(d, Sub(), c);
          }
        }
      }
    }
  }

  rdf::Dictionary& dictionary_;
  NaiveClosure result_;
  std::map<TermId, Pairs> by_predicate_;
};

}  // namespace

NaiveClosure CloseNaively(std::set<Triple> triples, rdf::Dictionary& dictionary) {
  return Naive(std::move(triples), dictionary).Run();
}

std::set<Triple> ComparableTriples(const std::set<Triple>& triples, rdf::Dictionary& dictionary) {
  const auto word = [&](std::string_view space, const char* name) {
    return dictionary.InternIri(std::string(space) + name);
  };
  const TermId type = word(rdf::kRdf, "type"), sub = word(rdf::kRdfs, "subClassOf");
  const std::set<TermId> reflexive = {
      sub, word(rdf::kOwl, "sameAs"), word(rdf::kRdfs, "subPropertyOf"),
      word(rdf::kOwl, "equivalentClass"), word(rdf::kOwl, "equivalentProperty")};
  std::set<Triple> comparable;
  for (const auto& [s, p, o] : triples) {
    if (dictionary.Kind(s) == rdf::TermKind::kLiteral) continue;
    if (s == o && reflexive.contains(p)) continue;
    if (p == sub && (o == word(rdf::kOwl, "Thing") || s == word(rdf::kOwl, "Nothing"))) continue;
    if (p == type &&
        (o == word(rdf::kOwl, "Thing") || rdf::IsSupportedDatatype(dictionary.Get(o).value))) {
      continue;
    }
    comparable.insert({s, p, dictionary.SameValue(o)});
  }
  return comparable;
}

std::set<Triple> ComparableTriples(const rdf::View& view) {
  const std::vector<Triple> all = view.Match({});
  return ComparableTriples({all.begin(), all.end()}, view.dictionary());
}

}  // namespace lares::testing
