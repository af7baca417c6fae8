#include "reasoner/owl/entailment.h"

#include <algorithm>
#include <map>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/on_demand.h"

namespace lares::owl {
namespace {

using rdf::TermId;
using rdf::Triple;

constexpr std::size_t kMaxAttempts = 1'000'000;

// Reads the blank nodes one triple at a time, the most determined triple first.
class Reader {
 public:
  Reader(const rdf::View& view, const rdf::Graph& conclusion)
      : view_(view), open_(conclusion.triples) {}

  Entailment Run() {
    answer_.follows = Satisfy();
    if (answer_.follows) answer_.missing.reset();
    return std::move(answer_);
  }

 private:
  TermId Read(TermId term) const {
    if (view_.dictionary().Kind(term) != rdf::TermKind::kBlank) return term;
    const auto known = reading_.find(term);
    return known == reading_.end() ? rdf::kAnyTerm : known->second;
  }
  rdf::Pattern Read(const Triple& triple) const {
    return {Read(triple.subject), Read(triple.predicate), Read(triple.object)};
  }

  // How many answers a triple leaves, about.
  std::size_t Openness(const Triple& triple) const {
    const rdf::Pattern pattern = Read(triple);
    const bool is_ground = pattern.subject != rdf::kAnyTerm && pattern.predicate != rdf::kAnyTerm &&
                           pattern.object != rdf::kAnyTerm;
    return is_ground ? 0 : 1 + view_.Estimate(pattern);
  }

  bool Satisfy() {
    if (open_.empty()) return true;
    const auto next =
        std::min_element(open_.begin(), open_.end(),
                         [&](const auto& a, const auto& b) { return Openness(a) < Openness(b); });
    const Triple triple = *next;
    open_.erase(next);
    if (SatisfyFirst(triple)) return true;
    if (!answer_.missing) answer_.missing = triple;
    open_.push_back(triple);
    return false;
  }

  bool SatisfyFirst(const Triple& triple) {
    if (++attempts_ > kMaxAttempts) {
      throw Error(Code::kTooLarge, "too many blank nodes that could mean too many things");
    }
    const rdf::Pattern pattern = Read(triple);
    if (Openness(triple) == 0) {
      const auto reason = Holds(view_, {pattern.subject, pattern.predicate, pattern.object});
      if (!reason) return false;
      if (!reason->rule.empty()) answer_.used.emplace(reason->rule);
      return Satisfy();
    }
    answer_.used.emplace("blank nodes");
    for (const Triple& found : view_.Match(pattern)) {
      const std::map<TermId, TermId> before = reading_;
      if (Bind(triple.subject, found.subject) && Bind(triple.predicate, found.predicate) &&
          Bind(triple.object, found.object) && Satisfy()) {
        return true;
      }
      reading_ = before;
    }
    return false;
  }

  bool Bind(TermId term, TermId meaning) {
    if (view_.dictionary().Kind(term) != rdf::TermKind::kBlank) return true;
    return reading_.emplace(term, meaning).first->second == meaning;
  }

  const rdf::View& view_;
  std::vector<Triple> open_;
  std::map<TermId, TermId> reading_;
  Entailment answer_;
  std::size_t attempts_ = 0;
};

}  // namespace

Entailment Entails(const rdf::View& view, const rdf::Graph& conclusion) {
  return Reader(view, conclusion).Run();
}

}  // namespace lares::owl
