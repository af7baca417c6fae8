#include "reasoner/sparql/join_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace lares::sparql {

using rdf::kAnyTerm;
using syntax::Node;
using syntax::Pattern;

namespace {

constexpr double kPathFan = 20;
constexpr double kPathAll = 1e7;

double QuickEstimate(const Pattern& pattern, Source& source, Context& context);

rdf::Pattern ConstantsOf(const syntax::TriplePattern& triple, const Context& context) {
  const auto at = [&](const Node& node) {
    return node.is_variable() ? kAnyTerm : context.constants[node.index];
  };
  return {at(triple.subject), at(triple.predicate), at(triple.object)};
}

// Rows of a whole pattern asked on its own, roughly.
double EstimateAll(const std::vector<Pattern>& children, Source& source, Context& context) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pattern& child : children) {
    if (child.kind == Pattern::Kind::kFilter || child.kind == Pattern::Kind::kOptional ||
        child.kind == Pattern::Kind::kMinus || child.kind == Pattern::Kind::kBind) {
      continue;
    }
    least = std::min(least, QuickEstimate(child, source, context));
  }
  return std::isinf(least) ? 1 : least;
}

double QuickEstimate(const Pattern& pattern, Source& source, Context& context) {
  switch (pattern.kind) {
    case Pattern::Kind::kTriples: {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& triple : pattern.triples) {
        const double rows = static_cast<double>(source.Estimate(ConstantsOf(triple, context)));
        least = std::min(least, rows);
      }
      return least;
    }
    case Pattern::Kind::kPath:
      return kPathAll;
    case Pattern::Kind::kValues:
      return static_cast<double>(pattern.rows.size());
    case Pattern::Kind::kUnion: {
      double sum = 0;
      for (const Pattern& child : pattern.children) sum += QuickEstimate(child, source, context);
      return sum;
    }
    case Pattern::Kind::kSelect: {
      const double rows = QuickEstimate(pattern.select->where, source, context);
      const auto& limit = pattern.select->limit;
      return limit ? std::min(rows, static_cast<double>(*limit)) : rows;
    }
    default:
      return EstimateAll(pattern.children, source, context);
  }
}

class Estimator {
 public:
  Estimator(const std::vector<JoinPart>& parts, Source& source, Context& context)
      : parts_(parts), source_(source), context_(context) {}

  // Rows that a part gives for each row in which `bound` columns have terms.
  double Rows(std::size_t part, const Slots& bound) {
    const JoinPart& joined = parts_[part];
    const unsigned mask = MaskOf(joined, bound);
    const auto [known, is_new] = known_.emplace(part * 8 + mask, 0.0);
    if (is_new) {
      known->second = joined.triple != nullptr ? TripleRows(*joined.triple, mask)
                                               : OtherRows(*joined.pattern, mask);
    }
    return known->second;
  }

 private:
  static bool Has(const Node& node, const Slots& bound) {
    return !node.is_variable() || bound.count(node.index) != 0;
  }

  // Which of subject, predicate, object are bound; for other patterns: the ends of a path, or
  // whether any column is.
  static unsigned MaskOf(const JoinPart& part, const Slots& bound) {
    if (part.triple != nullptr) {
      return (Has(part.triple->subject, bound) ? 1U : 0U) |
             (Has(part.triple->predicate, bound) ? 2U : 0U) |
             (Has(part.triple->object, bound) ? 4U : 0U);
    }
    if (part.pattern->kind == Pattern::Kind::kPath) {
      return (Has(part.pattern->ends.subject, bound) ? 1U : 0U) |
             (Has(part.pattern->ends.object, bound) ? 4U : 0U);
    }
    const bool shares = std::ranges::any_of(
        part.columns, [&](syntax::Slot slot) { return bound.count(slot) != 0; });
    return shares ? 1U : 0U;
  }

  double TripleRows(const syntax::TriplePattern& triple, unsigned mask) {
    constexpr std::size_t kSamples = 4;
    const rdf::Pattern constants = ConstantsOf(triple, context_);
    const double all = static_cast<double>(source_.Estimate(constants));
    const bool joins_subject = (mask & 1U) != 0 && triple.subject.is_variable();
    const bool joins_predicate = (mask & 2U) != 0 && triple.predicate.is_variable();
    const bool joins_object = (mask & 4U) != 0 && triple.object.is_variable();
    if (all <= 1 || (!joins_subject && !joins_predicate && !joins_object)) return all;
    if (mask == 7) return 0.5;  // a check
    double sum = 0;
    std::size_t samples = 0;
    source_.ForEach(constants, [&](const rdf::Triple& match) {
      rdf::Pattern joined = constants;
      if (joins_subject) joined.subject = match.subject;
      if (joins_predicate) joined.predicate = match.predicate;
      if (joins_object) joined.object = match.object;
      sum += static_cast<double>(source_.Estimate(joined));
      return ++samples < kSamples;
    });
    return samples == 0 ? 0 : sum / static_cast<double>(samples);
  }

  double OtherRows(const Pattern& pattern, unsigned mask) {
    if (pattern.kind == Pattern::Kind::kPath) {
      if (mask == 5) return 1;
      return mask != 0 ? kPathFan : kPathAll;
    }
    const double all = QuickEstimate(pattern, source_, context_);
    return mask == 0 ? all : std::sqrt(all);
  }

  const std::vector<JoinPart>& parts_;
  Source& source_;
  Context& context_;
  std::unordered_map<std::size_t, double> known_;
};

struct Order {
  std::vector<std::size_t> parts;
  std::vector<double> rows;
  double cost = 0;
};

bool Shares(const JoinPart& part, const Slots& bound) {
  return part.columns.empty() || std::ranges::any_of(part.columns, [&](syntax::Slot slot) {
           return bound.count(slot) != 0;
         });
}

// The cheapest next part, connected ones first.
std::size_t Cheapest(const std::vector<JoinPart>& parts, const std::vector<bool>& taken,
                     const Slots& bound, Estimator& estimator) {
  std::size_t best = parts.size();
  bool best_shares = false;
  double best_rows = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (taken[i]) continue;
    const bool shares = Shares(parts[i], bound);
    const double rows = estimator.Rows(i, bound);
    const bool is_better = best == parts.size() || (shares && !best_shares) ||
                           (shares == best_shares && rows < best_rows);
    if (!is_better) continue;
    best = i;
    best_shares = shares;
    best_rows = rows;
  }
  return best;
}

Order OrderFrom(std::optional<std::size_t> first, const std::vector<JoinPart>& parts, Slots bound,
                Estimator& estimator) {
  Order order;
  std::vector<bool> taken(parts.size());
  double rows = 1;
  while (order.parts.size() < parts.size()) {
    const std::size_t next =
        order.parts.empty() && first ? *first : Cheapest(parts, taken, bound, estimator);
    taken[next] = true;
    order.parts.push_back(next);
    order.rows.push_back(estimator.Rows(next, bound));
    rows = std::max(rows * order.rows.back(), 1e-3);
    order.cost += rows;
    bound.insert(parts[next].columns.begin(), parts[next].columns.end());
  }
  return order;
}

}  // namespace

void OrderJoin(std::vector<JoinPart>& parts, const Slots& bound, Source& source, Context& context) {
  constexpr std::size_t kMostTried = 8;
  if (parts.empty()) return;
  if (parts.size() == 1) {
    Estimator estimator(parts, source, context);
    parts[0].estimate = estimator.Rows(0, bound);
    return;
  }
  Estimator estimator(parts, source, context);
  Order best = OrderFrom(std::nullopt, parts, bound, estimator);
  for (std::size_t first = 0; parts.size() <= kMostTried && first < parts.size(); ++first) {
    Order other = OrderFrom(first, parts, bound, estimator);
    if (other.cost < best.cost) best = std::move(other);
  }
  std::vector<JoinPart> ordered;
  for (std::size_t i = 0; i < best.parts.size(); ++i) {
    ordered.push_back(std::move(parts[best.parts[i]]));
    ordered.back().estimate = best.rows[i];
  }
  parts = std::move(ordered);
}

}  // namespace lares::sparql
