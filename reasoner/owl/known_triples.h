// The triples that a derivation may rest on.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

enum class Literals {
  kAsObjects,   // what the view shows
  kAsSubjects,  // and what holds of literals: triples about them, equalities with them
};

// A view as rules see it. With Literals::kAsSubjects it is of generalised RDF: what is stored of
// literals is there too, and what is said of one literal holds of each other of its value. Of these
// others only those that a pattern names are visited.
class KnownTriples {
 public:
  KnownTriples(rdf::View view, Literals literals);

  const rdf::View& view() const { return view_; }
  bool is_general() const { return literals_ == Literals::kAsSubjects; }

  bool Contains(const rdf::Triple& triple) const {
    return view_.Contains(triple) || (is_general() && ContainsGeneral(triple));
  }
  // As View::Estimate.
  std::size_t Estimate(const rdf::Pattern& pattern) const {
    return view_.Estimate(pattern) + (is_general() ? CountOfTwins(pattern) : 0);
  }
  // As View::ForEach; a triple may come more than once.
  template <typename Visit>
  bool ForEach(const rdf::Pattern& pattern, Visit&& visit) const {
    return view_.ForEach(pattern, visit) && (!is_general() || ForEachGeneral(pattern, visit));
  }

 private:
  using Visitor = std::function<bool(const rdf::Triple&)>;

  rdf::TermId Representative(rdf::TermId term) const;
  bool IsLiteral(rdf::TermId term) const;
  bool IsOfClass(const rdf::Triple& stored) const;
  std::vector<rdf::TermId> Members(rdf::TermId representative) const;
  // The term and the other literals of its value.
  std::vector<rdf::TermId> Twins(rdf::TermId term) const;
  bool HoldsOfLiteral(const rdf::Triple& triple) const;
  bool ContainsGeneral(const rdf::Triple& triple) const;
  std::size_t CountOfTwins(const rdf::Pattern& pattern) const;
  bool ForEachGeneral(const rdf::Pattern& pattern, const Visitor& visit) const;
  bool ForEachAboutLiterals(const rdf::Pattern& pattern, const Visitor& visit) const;
  bool ForEachSame(const rdf::Pattern& pattern, const Visitor& visit) const;
  bool ForEachOfTwins(const rdf::Pattern& pattern, const Visitor& visit) const;

  rdf::View view_;
  Literals literals_;
  rdf::TermId same_as_{};
};

}  // namespace lares::owl
