#include "reasoner/owl/prover.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "reasoner/owl/proof_search.h"
#include "reasoner/owl/values.h"

namespace lares::owl {
namespace {

constexpr std::size_t kWorkOfFirstSearch = 1'000'000;
constexpr std::size_t kWorkWhereLiteralsMatter = 50'000;  // of the first search

bool LiteralsMatter(const rdf::View& view) {
  if (DependsOnValues(view)) return true;
  if (view.equality() == nullptr) return false;
  return !view.equality()->ForEachClass([&](std::span<const rdf::TermId> members) {
    return std::none_of(members.begin(), members.end(), [&](rdf::TermId term) {
      return view.dictionary().Kind(term) == rdf::TermKind::kLiteral;
    });
  });
}

}  // namespace

Prover::Prover(rdf::View view)
    : view_(std::move(view)), plain_(std::make_unique<ProofSearch>(view_, false)) {}
Prover::~Prover() = default;

// What a search has worked out it knows when it is asked again.
template <typename Ask>
std::optional<Proof> Prover::Try(const ProofOptions& options, const Ask& ask) {
  for (const std::size_t work : {kWorkWhereLiteralsMatter, kWorkOfFirstSearch}) {
    ProofOptions first = options;
    first.max_work = std::min(first.max_work, work);
    try {
      return ask(*plain_, first);
    } catch (const Error& error) {
      if (error.code() != Code::kTooLarge && error.code() != Code::kInternal) throw;
      const bool was_stopped_early = error.code() == Code::kTooLarge && first.max_work == work;
      if (!was_stopped_early || LiteralsMatter(view_)) break;
    }
  }
  if (!computing_) computing_ = std::make_unique<ProofSearch>(view_, true);
  return ask(*computing_, options);
}

std::optional<Proof> Prover::Why(const rdf::Triple& triple, const ProofOptions& options) {
  return Try(options, [&](ProofSearch& search, const ProofOptions& limits) {
    return search.Why(triple, limits);
  });
}

std::optional<Proof> Prover::WhyContradiction(const ProofOptions& options) {
  return Try(options, [&](ProofSearch& search, const ProofOptions& limits) {
    return search.WhyContradiction(limits);
  });
}

}  // namespace lares::owl
