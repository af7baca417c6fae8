// Which terms stand for one thing.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "ontology/triples/dictionary.h"
#include "ontology/triples/graph.h"

namespace lares::rdf {

// Classes of terms that owl:sameAs joins. A layer stores its triples by representatives: n names of
// one thing cost n entries here instead of n copies of every triple (Motik, Nenov, Piro, Horrocks
// 2015). A value; terms that are alone in their class take no room.
class Equality {
 public:
  explicit Equality(const Dictionary& dictionary, TermId same_as)
      : dictionary_(&dictionary), same_as_(same_as) {}

  bool empty() const { return members_of_.empty(); }
  TermId same_as() const { return same_as_; }  // owl:sameAs
  // That of the term's class; the term itself when it is alone. A literal stands in the class of
  // any literal of its value.
  TermId Representative(TermId term) const;
  Triple Normal(const Triple& triple) const {
    return {Representative(triple.subject), Representative(triple.predicate),
            Representative(triple.object)};
  }
  bool IsNormal(const Triple& triple) const {
    return !IsMerged(triple.subject) && !IsMerged(triple.predicate) && !IsMerged(triple.object);
  }
  // All terms of a class with more than one, the representative among them; empty otherwise.
  std::span<const TermId> Members(TermId representative) const;

  // Joins the classes of two terms. IRIs of RDF and OWL themselves represent before other IRIs,
  // these before blank nodes, these before literals; then the larger class does. Gives the terms
  // that got another representative, with every literal of the values that join as far as the
  // dictionary knows them; empty when both were in one class. Throws kUnsupported for two words of
  // RDF, RDFS or OWL.
  std::vector<TermId> Merge(TermId a, TermId b);
  // Makes a literal a member of the class that another of its value is in; false when none is, or
  // it was one.
  bool AddTwin(TermId literal);

  // visit(members) for each class with more than one member, until it gives false.
  bool ForEachClass(const std::function<bool(std::span<const TermId>)>& visit) const;

 private:
  // Whether another term represents this one.
  bool IsMerged(TermId term) const {
    return term >= least_merged_ && term <= most_merged_ && representative_of_.contains(term);
  }
  int Rank(TermId term) const;
  std::vector<TermId> TakeClass(TermId representative);
  void SetRepresentative(TermId term, TermId representative);

  const Dictionary* dictionary_;
  TermId same_as_;
  std::unordered_map<TermId, TermId> representative_of_;  // without representatives themselves
  std::unordered_map<TermId, std::vector<TermId>> members_of_;
  TermId least_merged_{UINT32_MAX}, most_merged_{};
};

}  // namespace lares::rdf
