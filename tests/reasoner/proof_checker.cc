#include "tests/reasoner/proof_checker.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "ontology/rdf/vocabulary.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/literal_checker.h"

namespace lares::testing {
namespace {

using rdf::TermId;
using rdf::Triple;
using Ids = std::vector<TermId>;
using Pairs = std::vector<std::pair<TermId, TermId>>;

// The premises of one step, and questions about them. A premise counts as used once it was asked
// for, so a step cannot carry premises that have nothing to do with it.
class Step {
 public:
  Step(std::vector<Triple> premises, Triple conclusion, rdf::Dictionary& dictionary)
      : premises_(std::move(premises)), conclusion_(conclusion), dictionary_(dictionary) {}

  TermId Name(std::string_view name) {
    if (name.starts_with("rdfs:")) {
      return dictionary_.InternIri(std::string(rdf::kRdfs).append(name.substr(5)));
    }
    const bool is_rdf = name.starts_with("rdf:");
    const std::string_view space = is_rdf ? rdf::kRdf : rdf::kOwl;
    return dictionary_.InternIri(std::string(space).append(name.substr(4)));
  }
  TermId Type() { return Name("rdf:type"); }

  bool Has(TermId s, TermId p, TermId o) {
    return std::find(premises_.begin(), premises_.end(), Triple{s, p, o}) != premises_.end();
  }
  Pairs Of(TermId p) const {
    Pairs pairs;
    for (const Triple& t : premises_) {
      if (t.predicate == p) pairs.emplace_back(t.subject, t.object);
    }
    return pairs;
  }
  Pairs Of(std::string_view p) { return Of(Name(p)); }
  Ids Values(TermId s, TermId p) const {
    Ids values;
    for (const Triple& t : premises_) {
      if (t.subject == s && t.predicate == p) values.push_back(t.object);
    }
    return values;
  }
  Ids Values(TermId s, std::string_view p) { return Values(s, Name(p)); }

  bool Concludes(TermId s, TermId p, TermId o) const { return conclusion_ == Triple{s, p, o}; }
  bool ConcludesType(TermId x, TermId c) { return Concludes(x, Type(), c); }
  const Triple& conclusion() const { return conclusion_; }
  const std::vector<Triple>& premises() const { return premises_; }
  std::size_t size() const { return premises_.size(); }

  bool IsNumber(TermId id, char digit) {
    const rdf::TermView view = dictionary_.Get(id);
    if (view.kind != rdf::TermKind::kLiteral) return false;
    return std::string(view.value).find_first_not_of("0+ ") == std::string::npos
               ? digit == '0'
               : digit == '1' && view.value.ends_with('1') &&
                     view.value.find_first_not_of("0+ ") == view.value.size() - 1;
  }

  // Lists that the premises spell out.
  std::vector<Ids> Lists(TermId head, std::size_t depth = 0) {
    if (head == Name("rdf:nil")) return {{}};
    std::vector<Ids> lists;
    if (depth > premises_.size()) return lists;
    for (const TermId rest : Values(head, "rdf:rest")) {
      for (const Ids& tail : Lists(rest, depth + 1)) {
        for (const TermId first : Values(head, "rdf:first")) {
          lists.push_back({first});
          lists.back().insert(lists.back().end(), tail.begin(), tail.end());
        }
      }
    }
    return lists;
  }

  std::optional<LiteralValue> MeaningOf(TermId term) const {
    return testing::MeaningOf(dictionary_.Get(term));
  }
  std::string_view IriOf(TermId term) const {
    const rdf::TermView view = dictionary_.Get(term);
    return view.kind == rdf::TermKind::kIri ? view.value : std::string_view();
  }
  // Whether a literal has a value that is none of the datatype's, or a text that says no value.
  bool IsOutside(TermId term, std::string_view datatype) const {
    const rdf::TermView view = dictionary_.Get(term);
    if (view.kind != rdf::TermKind::kLiteral) return false;
    const auto value = testing::MeaningOf(view);
    return value ? !IsOneOf(*value, datatype) : IsKnownDatatype(view.datatype);
  }
  // Whether two terms are literals of known values that differ, or do not.
  bool AreValues(TermId a, TermId b, bool equal) const {
    const auto first = MeaningOf(a), second = MeaningOf(b);
    return first && second && (*first == *second) == equal;
  }

 private:
  std::vector<Triple> premises_;
  Triple conclusion_;
  rdf::Dictionary& dictionary_;
};

struct Rule {
  int table;
  // Whether the premises satisfy the rule's body and give the conclusion.
  std::function<bool(Step&)> holds;
};

template <typename Range, typename Test>
bool Any(const Range& range, Test test) {
  return std::any_of(range.begin(), range.end(), test);
}

// some list of `owner` under `predicate`
bool AnyList(Step& t, std::string_view predicate,
             const std::function<bool(TermId owner, const Ids& members)>& test) {
  return Any(t.Of(predicate), [&](const auto& pair) {
    return Any(t.Lists(pair.second), [&](const Ids& list) { return test(pair.first, list); });
  });
}

bool AnyPair(const Ids& members, const std::function<bool(TermId, TermId)>& test) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      if (test(members[i], members[j])) return true;
    }
  }
  return false;
}

using Rules = std::map<std::string, Rule, std::less<>>;

void AddEquality(Rules& rules) {
  const auto same = [](Step& t) { return t.Name("owl:sameAs"); };
  rules["eq-ref"] = {4, [=](Step& t) {
                       const TermId x = t.conclusion().subject;
                       return t.size() == 0 && t.Concludes(x, same(t), x);
                     }};
  rules["eq-sym"] = {4, [=](Step& t) {
                       return t.size() == 1 && Any(t.Of(same(t)), [&](const auto& e) {
                                return t.Concludes(e.second, same(t), e.first);
                              });
                     }};
  rules["eq-trans"] = {4, [=](Step& t) {
                         return t.size() == 2 && Any(t.Of(same(t)), [&](const auto& e) {
                                  return Any(t.Values(e.second, same(t)), [&](TermId z) {
                                    return t.Concludes(e.first, same(t), z);
                                  });
                                });
                       }};
  const auto replace = [=](int place) {
    return [=](Step& t) {
      if (t.size() > 2) return false;
      return Any(t.Of(same(t)), [&](const auto& e) {
        return Any(t.premises(), [&](Triple other) {
          TermId& term = place == 0 ? other.subject : place == 1 ? other.predicate : other.object;
          if (term != e.first) return false;
          term = e.second;
          return other == t.conclusion();
        });
      });
    };
  };
  rules["eq-rep-s"] = {4, replace(0)};
  rules["eq-rep-p"] = {4, replace(1)};
  rules["eq-rep-o"] = {4, replace(2)};
  rules["eq-diff1"] = {4, [=](Step& t) {
                         return Any(t.Of("owl:differentFrom"), [&](const auto& e) {
                           return e.first == e.second || t.Has(e.first, same(t), e.second);
                         });
                       }};
  const auto different = [=](const char* members) {
    return [=](Step& t) {
      return AnyList(t, members, [&](TermId x, const Ids& list) {
        return t.Has(x, t.Type(), t.Name("owl:AllDifferent")) &&
               AnyPair(list, [&](TermId y, TermId z) { return t.Has(y, same(t), z); });
      });
    };
  };
  rules["eq-diff2"] = {4, different("owl:members")};
  rules["eq-diff3"] = {4, different("owl:distinctMembers")};
}

// p a <type>
Ids PropertiesOf(Step& t, std::string_view type) {
  Ids properties;
  for (const auto& [p, c] : t.Of(t.Type())) {
    if (c == t.Name(type)) properties.push_back(p);
  }
  return properties;
}

void AddProperties(Rules& rules) {
  rules["prp-dom"] = {5, [](Step& t) {
                        return Any(t.Of("rdfs:domain"), [&](const auto& e) {
                          return Any(t.Of(e.first), [&](const auto& xy) {
                            return t.ConcludesType(xy.first, e.second);
                          });
                        });
                      }};
  rules["prp-rng"] = {5, [](Step& t) {
                        return Any(t.Of("rdfs:range"), [&](const auto& e) {
                          return Any(t.Of(e.first), [&](const auto& xy) {
                            return t.ConcludesType(xy.second, e.second);
                          });
                        });
                      }};
  rules["prp-fp"] = {5, [](Step& t) {
                       return Any(PropertiesOf(t, "owl:FunctionalProperty"), [&](TermId p) {
                         return Any(t.Of(p), [&](const auto& xy) {
                           return Any(t.Values(xy.first, p), [&](TermId z) {
                             return t.Concludes(xy.second, t.Name("owl:sameAs"), z);
                           });
                         });
                       });
                     }};
  rules["prp-ifp"] = {5, [](Step& t) {
                        return Any(PropertiesOf(t, "owl:InverseFunctionalProperty"), [&](TermId p) {
                          return Any(t.Of(p), [&](const auto& xz) {
                            return Any(t.Of(p), [&](const auto& yz) {
                              return xz.second == yz.second &&
                                     t.Concludes(xz.first, t.Name("owl:sameAs"), yz.first);
                            });
                          });
                        });
                      }};
  rules["prp-irp"] = {5, [](Step& t) {
                        return Any(PropertiesOf(t, "owl:IrreflexiveProperty"), [&](TermId p) {
                          return Any(t.Of(p), [](const auto& e) { return e.first == e.second; });
                        });
                      }};
  rules["prp-symp"] = {
      5, [](Step& t) {
        return Any(PropertiesOf(t, "owl:SymmetricProperty"), [&](TermId p) {
          return Any(t.Of(p), [&](const auto& e) { return t.Concludes(e.second, p, e.first); });
        });
      }};
  rules["prp-asyp"] = {5, [](Step& t) {
                         return Any(PropertiesOf(t, "owl:AsymmetricProperty"), [&](TermId p) {
                           return Any(t.Of(p),
                                      [&](const auto& e) { return t.Has(e.second, p, e.first); });
                         });
                       }};
  rules["prp-trp"] = {5, [](Step& t) {
                        return Any(PropertiesOf(t, "owl:TransitiveProperty"), [&](TermId p) {
                          return Any(t.Of(p), [&](const auto& e) {
                            return Any(t.Values(e.second, p),
                                       [&](TermId z) { return t.Concludes(e.first, p, z); });
                          });
                        });
                      }};
  const auto below = [](const char* axiom, bool backwards) {
    return [=](Step& t) {
      return Any(t.Of(axiom), [&](const auto& e) {
        const auto [from, to] = backwards ? std::pair(e.second, e.first) : e;
        return Any(t.Of(from),
                   [&, to = to](const auto& xy) { return t.Concludes(xy.first, to, xy.second); });
      });
    };
  };
  rules["prp-spo1"] = {5, below("rdfs:subPropertyOf", false)};
  rules["prp-eqp1"] = {5, below("owl:equivalentProperty", false)};
  rules["prp-eqp2"] = {5, below("owl:equivalentProperty", true)};
  const auto inverse = [](bool backwards) {
    return [=](Step& t) {
      return Any(t.Of("owl:inverseOf"), [&](const auto& e) {
        const auto [from, to] = backwards ? std::pair(e.second, e.first) : e;
        return Any(t.Of(from),
                   [&, to = to](const auto& xy) { return t.Concludes(xy.second, to, xy.first); });
      });
    };
  };
  rules["prp-inv1"] = {5, inverse(false)};
  rules["prp-inv2"] = {5, inverse(true)};
  rules["prp-spo2"] = {5, [](Step& t) {
                         return AnyList(t, "owl:propertyChainAxiom",
                                        [&](TermId p, const Ids& list) {
                                          if (list.empty() || t.conclusion().predicate != p)
                                            return false;
                                          std::set<TermId> reached = {t.conclusion().subject};
                                          for (const TermId link : list) {
                                            std::set<TermId> further;
                                            for (const TermId x : reached) {
                                              for (const TermId y : t.Values(x, link))
                                                further.insert(y);
                                            }
                                            reached = further;
                                          }
                                          return reached.contains(t.conclusion().object);
                                        });
                       }};
  rules["prp-key"] = {5, [](Step& t) {
                        return AnyList(t, "owl:hasKey", [&](TermId c, const Ids& list) {
                          const auto [x, same, y] = t.conclusion();
                          if (list.empty() || same != t.Name("owl:sameAs")) return false;
                          if (!t.Has(x, t.Type(), c) || !t.Has(y, t.Type(), c)) return false;
                          return std::all_of(list.begin(), list.end(), [&, x = x, y = y](TermId p) {
                            return Any(t.Values(x, p), [&](TermId z) { return t.Has(y, p, z); });
                          });
                        });
                      }};
  rules["prp-pdw"] = {5, [](Step& t) {
                        return Any(t.Of("owl:propertyDisjointWith"), [&](const auto& e) {
                          return Any(t.Of(e.first), [&](const auto& xy) {
                            return t.Has(xy.first, e.second, xy.second);
                          });
                        });
                      }};
  rules["prp-adp"] = {
      5, [](Step& t) {
        return AnyList(t, "owl:members", [&](TermId x, const Ids& list) {
          return t.Has(x, t.Type(), t.Name("owl:AllDisjointProperties")) &&
                 AnyPair(list, [&](TermId p, TermId q) {
                   return Any(t.Of(p), [&](const auto& e) { return t.Has(e.first, q, e.second); });
                 });
        });
      }};
  const auto negative = [](const char* target) {
    return [=](Step& t) {
      return Any(t.Of("owl:sourceIndividual"), [&](const auto& e) {
        return Any(t.Values(e.first, "owl:assertionProperty"), [&](TermId p) {
          return Any(t.Values(e.first, target), [&](TermId j) { return t.Has(e.second, p, j); });
        });
      });
    };
  };
  rules["prp-npa1"] = {5, negative("owl:targetIndividual")};
  rules["prp-npa2"] = {5, negative("owl:targetValue")};
}

// Restrictions on a property: (restriction, property, filler).
bool AnyRestriction(Step& t, std::string_view filler,
                    const std::function<bool(TermId r, TermId p, TermId value)>& test) {
  return Any(t.Of("owl:onProperty"), [&](const auto& e) {
    return Any(t.Values(e.first, filler),
               [&](TermId value) { return test(e.first, e.second, value); });
  });
}

void AddClasses(Rules& rules) {
  rules["cls-nothing2"] = {6, [](Step& t) {
                             return Any(t.Of(t.Type()), [&](const auto& e) {
                               return e.second == t.Name("owl:Nothing");
                             });
                           }};
  rules["cls-int1"] = {6, [](Step& t) {
                         return AnyList(t, "owl:intersectionOf", [&](TermId c, const Ids& list) {
                           const TermId x = t.conclusion().subject;
                           return !list.empty() && t.ConcludesType(x, c) &&
                                  std::all_of(list.begin(), list.end(),
                                              [&](TermId d) { return t.Has(x, t.Type(), d); });
                         });
                       }};
  rules["cls-int2"] = {6, [](Step& t) {
                         return AnyList(t, "owl:intersectionOf", [&](TermId c, const Ids& list) {
                           const TermId x = t.conclusion().subject;
                           return t.Has(x, t.Type(), c) &&
                                  Any(list, [&](TermId d) { return t.ConcludesType(x, d); });
                         });
                       }};
  rules["cls-uni"] = {6, [](Step& t) {
                        return AnyList(t, "owl:unionOf", [&](TermId c, const Ids& list) {
                          const TermId x = t.conclusion().subject;
                          return t.ConcludesType(x, c) &&
                                 Any(list, [&](TermId d) { return t.Has(x, t.Type(), d); });
                        });
                      }};
  rules["cls-oo"] = {6, [](Step& t) {
                       return AnyList(t, "owl:oneOf", [&](TermId c, const Ids& list) {
                         return Any(list, [&](TermId x) { return t.ConcludesType(x, c); });
                       });
                     }};
  rules["cls-com"] = {6, [](Step& t) {
                        return Any(t.Of("owl:complementOf"), [&](const auto& e) {
                          return Any(t.Of(t.Type()), [&](const auto& x) {
                            return x.second == e.first && t.Has(x.first, t.Type(), e.second);
                          });
                        });
                      }};
  rules["cls-svf1"] = {
      6, [](Step& t) {
        return AnyRestriction(t, "owl:someValuesFrom", [&](TermId r, TermId p, TermId c) {
          return Any(t.Of(p), [&](const auto& uv) {
            return t.Has(uv.second, t.Type(), c) && t.ConcludesType(uv.first, r);
          });
        });
      }};
  rules["cls-svf2"] = {
      6, [](Step& t) {
        return AnyRestriction(t, "owl:someValuesFrom", [&](TermId r, TermId p, TermId c) {
          return c == t.Name("owl:Thing") &&
                 Any(t.Of(p), [&](const auto& uv) { return t.ConcludesType(uv.first, r); });
        });
      }};
  rules["cls-avf"] = {
      6, [](Step& t) {
        return AnyRestriction(t, "owl:allValuesFrom", [&](TermId r, TermId p, TermId c) {
          return Any(t.Of(p), [&](const auto& uv) {
            return t.Has(uv.first, t.Type(), r) && t.ConcludesType(uv.second, c);
          });
        });
      }};
  rules["cls-hv1"] = {6, [](Step& t) {
                        return AnyRestriction(t, "owl:hasValue", [&](TermId r, TermId p, TermId y) {
                          const TermId u = t.conclusion().subject;
                          return t.Has(u, t.Type(), r) && t.Concludes(u, p, y);
                        });
                      }};
  rules["cls-hv2"] = {6, [](Step& t) {
                        return AnyRestriction(t, "owl:hasValue", [&](TermId r, TermId p, TermId y) {
                          const TermId u = t.conclusion().subject;
                          return t.Has(u, p, y) && t.ConcludesType(u, r);
                        });
                      }};
  // At most `digit`; `qualified`: of owl:onClass, `of_thing`: which is owl:Thing.
  const auto at_most = [](char digit, bool qualified, bool of_thing) {
    return [=](Step& t) {
      const char* cardinality = qualified ? "owl:maxQualifiedCardinality" : "owl:maxCardinality";
      return AnyRestriction(t, cardinality, [&](TermId r, TermId p, TermId n) {
        if (!t.IsNumber(n, digit)) return false;
        const Ids classes = qualified ? t.Values(r, "owl:onClass") : Ids{t.Name("owl:Thing")};
        return Any(classes, [&](TermId c) {
          if (of_thing != (c == t.Name("owl:Thing")) && qualified && of_thing) return false;
          const auto counts = [&](TermId y) { return of_thing || t.Has(y, t.Type(), c); };
          return Any(t.Of(t.Type()), [&](const auto& e) {
            if (e.second != r) return false;
            return Any(t.Values(e.first, p), [&](TermId y) {
              if (!counts(y)) return false;
              if (digit == '0') return true;
              return Any(t.Values(e.first, p), [&](TermId z) {
                return counts(z) && t.Concludes(y, t.Name("owl:sameAs"), z);
              });
            });
          });
        });
      });
    };
  };
  rules["cls-maxc1"] = {6, at_most('0', false, true)};
  rules["cls-maxc2"] = {6, at_most('1', false, true)};
  rules["cls-maxqc1"] = {6, at_most('0', true, false)};
  rules["cls-maxqc2"] = {6, at_most('0', true, true)};
  rules["cls-maxqc3"] = {6, at_most('1', true, false)};
  rules["cls-maxqc4"] = {6, at_most('1', true, true)};
}

void AddClassAxioms(Rules& rules) {
  const auto below = [](const char* axiom, bool backwards) {
    return [=](Step& t) {
      return t.size() == 2 && Any(t.Of(axiom), [&](const auto& e) {
               const auto [from, to] = backwards ? std::pair(e.second, e.first) : e;
               const TermId x = t.conclusion().subject;
               return t.Has(x, t.Type(), from) && t.ConcludesType(x, to);
             });
    };
  };
  rules["cax-sco"] = {7, below("rdfs:subClassOf", false)};
  rules["cax-eqc1"] = {7, below("owl:equivalentClass", false)};
  rules["cax-eqc2"] = {7, below("owl:equivalentClass", true)};
  rules["cax-dw"] = {7, [](Step& t) {
                       return Any(t.Of("owl:disjointWith"), [&](const auto& e) {
                         return Any(t.Of(t.Type()), [&](const auto& x) {
                           return x.second == e.first && t.Has(x.first, t.Type(), e.second);
                         });
                       });
                     }};
  rules["cax-adc"] = {7, [](Step& t) {
                        return AnyList(t, "owl:members", [&](TermId a, const Ids& list) {
                          return t.Has(a, t.Type(), t.Name("owl:AllDisjointClasses")) &&
                                 AnyPair(list, [&](TermId c, TermId d) {
                                   return Any(t.Of(t.Type()), [&](const auto& x) {
                                     return x.second == c && t.Has(x.first, t.Type(), d);
                                   });
                                 });
                        });
                      }};
}

void AddSchema(Rules& rules) {
  const auto reflexive = [](const char* wide, const char* narrow, bool with_bounds) {
    return [=](Step& t) {
      const auto [s, p, o] = t.conclusion();
      if (t.size() > 2) return false;
      // With eq-rep-o in the same step: s ⊑ s, s = o.
      const bool is_reflexive = s == o || t.Has(s, t.Name("owl:sameAs"), o);
      if (is_reflexive && (p == t.Name(wide) || p == t.Name(narrow))) return true;
      return with_bounds && p == t.Name(wide) &&
             (o == t.Name("owl:Thing") || s == t.Name("owl:Nothing"));
    };
  };
  rules["scm-cls"] = {9, reflexive("rdfs:subClassOf", "owl:equivalentClass", true)};
  rules["scm-op"] = {9, reflexive("rdfs:subPropertyOf", "owl:equivalentProperty", false)};
  rules["scm-dp"] = rules["scm-op"];
  const auto transitive = [](const char* p) {
    return [=](Step& t) {
      return t.size() == 2 && Any(t.Of(p), [&](const auto& e) {
               return Any(t.Values(e.second, p),
                          [&](TermId z) { return t.Concludes(e.first, t.Name(p), z); });
             });
    };
  };
  rules["scm-sco"] = {9, transitive("rdfs:subClassOf")};
  rules["scm-spo"] = {9, transitive("rdfs:subPropertyOf")};
  const auto split = [](const char* equivalent, const char* sub) {
    return [=](Step& t) {
      return t.size() == 1 && Any(t.Of(equivalent), [&](const auto& e) {
               return t.Concludes(e.first, t.Name(sub), e.second) ||
                      t.Concludes(e.second, t.Name(sub), e.first);
             });
    };
  };
  rules["scm-eqc1"] = {9, split("owl:equivalentClass", "rdfs:subClassOf")};
  rules["scm-eqp1"] = {9, split("owl:equivalentProperty", "rdfs:subPropertyOf")};
  const auto join = [](const char* equivalent, const char* sub) {
    return [=](Step& t) {
      const auto [s, p, o] = t.conclusion();
      return t.size() == 2 && p == t.Name(equivalent) && t.Has(s, t.Name(sub), o) &&
             t.Has(o, t.Name(sub), s);
    };
  };
  rules["scm-eqc2"] = {9, join("owl:equivalentClass", "rdfs:subClassOf")};
  rules["scm-eqp2"] = {9, join("owl:equivalentProperty", "rdfs:subPropertyOf")};
  const auto wider = [](const char* end) {
    return [=](Step& t) {
      return t.size() == 2 && Any(t.Of(end), [&](const auto& e) {
               return Any(t.Values(e.second, "rdfs:subClassOf"),
                          [&](TermId d) { return t.Concludes(e.first, t.Name(end), d); });
             });
    };
  };
  rules["scm-dom1"] = {9, wider("rdfs:domain")};
  rules["scm-rng1"] = {9, wider("rdfs:range")};
  const auto narrower = [](const char* end) {
    return [=](Step& t) {
      return t.size() == 2 && Any(t.Of("rdfs:subPropertyOf"), [&](const auto& e) {
               return Any(t.Values(e.second, end),
                          [&](TermId c) { return t.Concludes(e.first, t.Name(end), c); });
             });
    };
  };
  rules["scm-dom2"] = {9, narrower("rdfs:domain")};
  rules["scm-rng2"] = {9, narrower("rdfs:range")};
  // Two restrictions; premises of the form a ⊑ a may be missing.
  const auto restrictions = [](const char* filler, bool by_filler, bool turned) {
    return [=](Step& t) {
      const auto sub = [&](TermId a, std::string_view p, TermId b) {
        return a == b || t.Has(a, t.Name(p), b);
      };
      return AnyRestriction(t, filler, [&](TermId c, TermId p, TermId y) {
        return AnyRestriction(t, filler, [&](TermId d, TermId q, TermId z) {
          const bool fits = by_filler ? p == q && sub(y, "rdfs:subClassOf", z)
                                      : y == z && sub(p, "rdfs:subPropertyOf", q);
          const auto [low, high] = turned ? std::pair(d, c) : std::pair(c, d);
          return fits && t.Concludes(low, t.Name("rdfs:subClassOf"), high);
        });
      });
    };
  };
  rules["scm-hv"] = {9, restrictions("owl:hasValue", false, false)};
  rules["scm-svf1"] = {9, restrictions("owl:someValuesFrom", true, false)};
  rules["scm-svf2"] = {9, restrictions("owl:someValuesFrom", false, false)};
  rules["scm-avf1"] = {9, restrictions("owl:allValuesFrom", true, false)};
  rules["scm-avf2"] = {9, restrictions("owl:allValuesFrom", false, true)};
  const auto members = [](const char* list_of, bool up) {
    return [=](Step& t) {
      return AnyList(t, list_of, [&](TermId c, const Ids& list) {
        return Any(list, [&](TermId d) {
          return up ? t.Concludes(d, t.Name("rdfs:subClassOf"), c)
                    : t.Concludes(c, t.Name("rdfs:subClassOf"), d);
        });
      });
    };
  };
  rules["scm-int"] = {9, members("owl:intersectionOf", false)};
  rules["scm-uni"] = {9, members("owl:unionOf", true)};
}

void AddAxioms(Rules& rules) {
  const auto is_class = [](const char* name) {
    return [=](Step& t) {
      return t.size() == 0 && t.ConcludesType(t.Name(name), t.Name("owl:Class"));
    };
  };
  rules["cls-thing"] = {6, is_class("owl:Thing")};
  rules["cls-nothing1"] = {6, is_class("owl:Nothing")};
}

// Table 8.
void AddDatatypes(Rules& rules) {
  rules["dt-type1"] = {8, [](Step& t) {
                         const auto [s, p, o] = t.conclusion();
                         return t.size() == 0 && p == t.Type() && o == t.Name("rdfs:Datatype") &&
                                IsKnownDatatype(t.IriOf(s));
                       }};
  rules["dt-type2"] = {8, [](Step& t) {
                         const auto [s, p, o] = t.conclusion();
                         const auto value = t.MeaningOf(s);
                         return t.size() == 0 && p == t.Type() && value &&
                                IsOneOf(*value, t.IriOf(o));
                       }};
  rules["dt-eq"] = {8, [](Step& t) {
                      const auto [s, p, o] = t.conclusion();
                      return t.size() == 0 && p == t.Name("owl:sameAs") && t.AreValues(s, o, true);
                    }};
  rules["dt-diff"] = {8, [](Step& t) {
                        const auto [s, p, o] = t.conclusion();
                        return t.size() == 0 && p == t.Name("owl:differentFrom") &&
                               t.AreValues(s, o, false);
                      }};
  rules["dt-not-type"] = {8, [](Step& t) {
                            if (t.size() != 1) return false;
                            const auto [s, p, o] = t.premises().front();
                            const std::string_view datatype = t.IriOf(o);
                            if (p != t.Type() || !IsKnownDatatype(datatype)) return false;
                            return t.IsOutside(s, datatype);
                          }};
}

const Rules& AllRules() {
  static const Rules rules = [] {
    Rules all;
    AddEquality(all);
    AddProperties(all);
    AddClasses(all);
    AddClassAxioms(all);
    AddSchema(all);
    AddAxioms(all);
    AddDatatypes(all);
    return all;
  }();
  return rules;
}

std::string CheckStep(const owl::Proof& proof, const owl::ProofNode& node, const rdf::View& view) {
  const auto rule = AllRules().find(node.rule);
  if (rule == AllRules().end()) return "no such rule: " + node.rule;
  if (rule->second.table != node.table) return node.rule + " is in another table";
  std::vector<Triple> premises;
  for (const std::size_t premise : node.premises) premises.push_back(proof.nodes[premise].triple);
  Step step(premises, node.triple, view.dictionary());
  if (!rule->second.holds(step)) return "does not follow by " + node.rule;
  for (std::size_t left_out = 0; left_out < premises.size(); ++left_out) {
    std::vector<Triple> fewer = premises;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (std::find(fewer.begin(), fewer.end(), premises[left_out]) != fewer.end()) continue;
    Step smaller(fewer, node.triple, view.dictionary());
    // A contradiction may be there twice over (a list that repeats a class), and what is said about
    // two restrictions may overlap.
    const bool may_overlap = node.is_contradiction() || node.rule.starts_with("scm-");
    if (!may_overlap && rule->second.holds(smaller))
      return "a premise of " + node.rule + " is not needed";
  }
  return "";
}

}  // namespace

std::string CheckProof(const owl::Proof& proof, const rdf::View& view) {
  if (proof.nodes.empty()) return "there is no conclusion";
  std::set<Triple> seen;
  std::vector<bool> is_used(proof.nodes.size(), false);
  is_used.back() = true;
  for (std::size_t i = 0; i < proof.nodes.size(); ++i) {
    const owl::ProofNode& node = proof.nodes[i];
    const std::string at = "node " + std::to_string(i) + ": ";
    if (!seen.insert(node.triple).second) return at + "a triple is there twice";
    if (node.is_contradiction() && i + 1 != proof.nodes.size()) return at + "nothing follows";
    for (const std::size_t premise : node.premises) {
      if (premise >= i) return at + "rests on what comes later";
      is_used[premise] = true;
    }
    if (node.is_asserted()) {
      if (!node.premises.empty()) return at + "a leaf has premises";
      if (node.graphs.empty() || node.graphs != view.GraphsOf(node.triple)) {
        return at + "is not asserted there";
      }
      continue;
    }
    if (!node.graphs.empty()) return at + "a step names documents";
    const std::string problem = CheckStep(proof, node, view);
    if (!problem.empty()) return at + problem;
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end()) return "a node serves nothing";
  return "";
}

}  // namespace lares::testing
