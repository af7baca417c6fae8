// Where triples are matched: a whole view, or the triples of named graphs.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/sparql/function_ref.h"
#include "reasoner/sparql/limits.h"

namespace lares::sparql {

using Visit = FunctionRef<bool(const rdf::Triple&)>;

class Source {
 public:
  virtual ~Source() = default;
  // Calls `visit` for each match until it returns false; true when all were visited.
  virtual bool ForEach(const rdf::Pattern& pattern, Visit visit) = 0;
  // An upper bound on the number of matches, quickly.
  virtual std::size_t Estimate(const rdf::Pattern& pattern) = 0;
};

class ViewSource : public Source {
 public:
  explicit ViewSource(const rdf::View& view) : view_(view) {}
  bool ForEach(const rdf::Pattern& pattern, Visit visit) override;
  std::size_t Estimate(const rdf::Pattern& pattern) override;

 private:
  const rdf::View& view_;
};

// Sorted, distinct triples; other orders are made when a pattern first needs them, and charged.
class ListSource : public Source {
 public:
  ListSource(std::span<const rdf::Triple> triples, Account& account)
      : spo_(triples), charge_(account) {}
  // The union of several lists.
  ListSource(const std::vector<std::span<const rdf::Triple>>& lists, Account& account);
  bool ForEach(const rdf::Pattern& pattern, Visit visit) override;
  std::size_t Estimate(const rdf::Pattern& pattern) override;

 private:
  std::span<const rdf::Triple> Run(const rdf::Pattern& pattern);
  const std::vector<rdf::Triple>& Order(bool by_predicate);

  std::span<const rdf::Triple> spo_;
  std::vector<rdf::Triple> own_;
  std::optional<std::vector<rdf::Triple>> pos_, osp_;
  Charge charge_;
};

}  // namespace lares::sparql
