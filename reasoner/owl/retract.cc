#include "reasoner/owl/retract.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace lares::owl {
namespace {

using Terms = std::vector<rdf::TermId>;

constexpr std::size_t kPairsInAStep = 32;

// Takes from the layer whatever may rest on what is taken back.
class Deletion {
 public:
  Deletion(const Retraction& retraction, TripleSet& deleted)
      : retraction_(retraction), view_(retraction.step.view()), deleted_(deleted) {}

  void Run() {
    for (const rdf::Triple& triple : retraction_.taken_back) Delete(triple, true);
    const OneStep::VisitConclusion visit = [&](const rdf::Triple& triple) {
      Delete(triple, true);
      return true;
    };
    while (!open_.empty() && !gave_up()) {
      const auto [triple, spreads] = open_.back();
      open_.pop_back();
      retraction_.step.ForwardFrom(triple, {}, visit);
      if (spreads && retraction_.step.IsTransitive(triple.predicate, {})) Spread(triple);
    }
  }

  bool gave_up() const {
    return retraction_.step.gave_up() || deleted_.size() > retraction_.max_deleted;
  }

 private:
  struct Open {
    rdf::Triple triple;
    bool spreads = true;  // along its property, should that be transitive
  };

  void Delete(const rdf::Triple& triple, bool spreads) {
    if (deleted_.contains(triple) || !retraction_.is_in_layer(triple) ||
        retraction_.stays_asserted(triple)) {
      return;
    }
    deleted_.insert(triple);
    open_.push_back({triple, spreads});
  }

  // A pair x → y carries every pair from what reaches x to what y reaches, and these, the layer
  // being closed, carry no others. (Where x ⊑ owl:Thing and owl:Nothing ⊑ x are left out as
  // trivial, it is not closed.)
  void Spread(const rdf::Triple& pair) {
    const Vocabulary& words = retraction_.step.words();
    const bool is_closed = pair.predicate != words.sub_class_of ||
                           (pair.subject != words.thing && pair.object != words.nothing);
    Terms sources = view_.Subjects(pair.predicate, pair.subject);
    Terms targets = view_.Objects(pair.object, pair.predicate);
    sources.push_back(pair.subject);
    targets.push_back(pair.object);
    for (const rdf::TermId source : sources) {
      retraction_.step.Count(1 + targets.size() / kPairsInAStep);
      if (gave_up()) return;
      for (const rdf::TermId target : targets) {
        Delete({source, pair.predicate, target}, !is_closed);
      }
    }
  }

  const Retraction& retraction_;
  const rdf::View& view_;
  TripleSet& deleted_;
  std::vector<Open> open_;
};

// Finds what of the deleted follows in one step from what is left.
class Rederivation {
 public:
  Rederivation(const Retraction& retraction, Retracted& retracted)
      : retraction_(retraction),
        view_(retraction.step.view()),
        retracted_(retracted),
        alive_([&](const rdf::Triple& triple) { return !retracted.deleted.contains(triple); }) {}

  void Run() {
    std::map<rdf::TermId, std::vector<rdf::Triple>> pairs;  // by transitive property
    for (const rdf::Triple& triple : retracted_.deleted) {
      if (retraction_.step.IsTrivial(triple)) continue;
      if (Follows(triple)) {
        retracted_.restored.push_back(triple);
      } else if (IsTransitive(triple.predicate)) {
        pairs[triple.predicate].push_back(triple);
      }
      if (retraction_.step.gave_up()) return;
    }
    for (const auto& [property, deleted] : pairs) RederivePairs(property, deleted);
  }

 private:
  bool Follows(const rdf::Triple& triple) {
    bool follows = false;
    retraction_.step.BackwardTo(triple, alive_, [&](std::span<const rdf::Triple>) {
      follows = true;
      return false;
    });
    return follows;
  }

  bool IsTransitive(rdf::TermId property) {
    const auto [known, is_new] = is_transitive_.try_emplace(property);
    if (is_new) known->second = retraction_.step.IsTransitive(property, alive_);
    return known->second;
  }

  // From the side with fewer ends.
  void RederivePairs(rdf::TermId property, const std::vector<rdf::Triple>& pairs) {
    std::map<rdf::TermId, Terms> by_subject, by_object;
    for (const auto& [subject, p, object] : pairs) {
      by_subject[subject].push_back(object);
      by_object[object].push_back(subject);
    }
    const bool backwards = by_object.size() < by_subject.size();
    for (auto& [near, far] : backwards ? by_object : by_subject) {
      RederivePairs(property, backwards, near, far);
    }
  }

  // Those of `near` → `far` (or, `backwards`, `far` → `near`) that go through something between.
  void RederivePairs(rdf::TermId property, bool backwards, rdf::TermId near, Terms& far) {
    std::sort(far.begin(), far.end());
    std::vector<bool> found(far.size());
    for (const rdf::TermId middle : Neighbours(property, backwards, near)) {
      const Terms& ends = Neighbours(property, backwards, middle);
      retraction_.step.Count(1 + ends.size() / kPairsInAStep);
      if (retraction_.step.gave_up()) return;
      for (const rdf::TermId end : ends) {
        const auto place = std::lower_bound(far.begin(), far.end(), end);
        if (place == far.end() || *place != end) continue;
        const auto number = static_cast<std::size_t>(place - far.begin());
        if (!found[number]) retracted_.restored.push_back(Pair(property, backwards, near, end));
        found[number] = true;
      }
    }
  }

  // What `node` leads to (or what leads to it) by pairs that are left.
  const Terms& Neighbours(rdf::TermId property, bool backwards, rdf::TermId node) {
    const auto [known, is_new] = neighbours_.try_emplace({property, backwards, node});
    if (is_new) {
      known->second = backwards ? view_.Subjects(property, node) : view_.Objects(node, property);
      retraction_.step.Count(1 + known->second.size() / kPairsInAStep);
      std::erase_if(known->second, [&](rdf::TermId other) {
        return !alive_(Pair(property, backwards, node, other));
      });
    }
    return known->second;
  }

  static rdf::Triple Pair(rdf::TermId property, bool backwards, rdf::TermId near, rdf::TermId far) {
    return backwards ? rdf::Triple{far, property, near} : rdf::Triple{near, property, far};
  }

  const Retraction& retraction_;
  const rdf::View& view_;
  Retracted& retracted_;
  OneStep::Alive alive_;
  std::map<rdf::TermId, bool> is_transitive_;
  std::map<std::tuple<rdf::TermId, bool, rdf::TermId>, Terms> neighbours_;
};

}  // namespace

std::optional<Retracted> DeleteAndRederive(const Retraction& retraction) {
  Retracted retracted;
  Deletion deletion(retraction, retracted.deleted);
  deletion.Run();
  if (deletion.gave_up()) return std::nullopt;
  Rederivation(retraction, retracted).Run();
  if (retraction.step.gave_up()) return std::nullopt;
  return retracted;
}

}  // namespace lares::owl
