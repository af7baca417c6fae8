#include "reasoner/owl/retract.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace lares::owl {
namespace {

// The facts that were looked at, each with the ways to conclude it. A way counts the premises that
// are not proved yet; proving the last proves the conclusion (Dowling & Gallier 1984).
class Provability {
 public:
  Provability(const Retraction& retraction, const TripleSet& deleted)
      : retraction_(retraction),
        alive_([&](const rdf::Triple& triple) { return !deleted.contains(triple); }) {}

  // Whether `triple` follows from what stays. A fact that was looked at and not proved is not
  // provable, now or later.
  bool Check(const rdf::Triple& triple) {
    std::vector<rdf::Triple> open = {triple};
    while (!open.empty() && !retraction_.step.gave_up()) {
      const rdf::Triple next = open.back();
      open.pop_back();
      const auto [known, is_new] = facts_.try_emplace(next);
      if (is_new) LookAt(next, open);
    }
    return facts_[triple].is_proved;
  }

 private:
  struct Way {
    rdf::Triple conclusion;
    std::size_t unproved = 0;
  };
  struct Fact {
    bool is_proved = false;
    std::vector<std::uint32_t> waiting;  // ways with this premise
  };

  bool IsGiven(const rdf::Triple& triple) const {
    return !retraction_.is_in_layer(triple) || retraction_.stays_asserted(triple);
  }

  void LookAt(const rdf::Triple& triple, std::vector<rdf::Triple>& open) {
    std::vector<rdf::Triple> missing;
    const auto visit = [&](std::span<const rdf::Triple> premises) {
      missing.clear();
      for (const rdf::Triple& premise : premises) {
        const auto fact = facts_.find(premise);
        if (fact != facts_.end() ? !fact->second.is_proved : !IsGiven(premise)) {
          missing.push_back(premise);
        }
      }
      if (missing.empty()) {
        Prove(triple);
        return false;
      }
      const auto way = static_cast<std::uint32_t>(ways_.size());
      ways_.push_back({triple, missing.size()});
      for (const rdf::Triple& premise : missing) {
        const auto fact = facts_.find(premise);
        if (fact == facts_.end()) {
          open.push_back(premise);
          pending_[premise].push_back(way);
        } else {
          fact->second.waiting.push_back(way);
        }
      }
      return true;
    };
    if (const auto pending = pending_.find(triple); pending != pending_.end()) {
      facts_[triple].waiting = std::move(pending->second);
      pending_.erase(pending);
    }
    retraction_.step.BackwardTo(triple, alive_, visit);
  }

  void Prove(const rdf::Triple& triple) {
    std::vector<rdf::Triple> proved = {triple};
    while (!proved.empty()) {
      Fact& fact = facts_[proved.back()];
      proved.pop_back();
      if (std::exchange(fact.is_proved, true)) continue;
      for (const std::uint32_t way : fact.waiting) {
        if (--ways_[way].unproved == 0) proved.push_back(ways_[way].conclusion);
      }
    }
  }

  const Retraction& retraction_;
  OneStep::Alive alive_;
  std::unordered_map<rdf::Triple, Fact, TripleHash> facts_;
  std::unordered_map<rdf::Triple, std::vector<std::uint32_t>, TripleHash> pending_;
  std::vector<Way> ways_;
};

}  // namespace

Retracted DeleteAndRederive(const Retraction& retraction) {
  Retracted retracted;
  std::vector<rdf::Triple> open(retraction.taken_back.begin(), retraction.taken_back.end());
  retracted.deleted.insert(open.begin(), open.end());
  const OneStep::VisitConclusion add = [&](const rdf::Triple& triple) {
    if (!retracted.deleted.contains(triple) && retraction.is_in_layer(triple) &&
        !retraction.stays_asserted(triple)) {
      retracted.deleted.insert(triple);
      open.push_back(triple);
    }
    return true;
  };
  while (!open.empty() && !retraction.step.gave_up()) {
    const rdf::Triple triple = open.back();
    open.pop_back();
    retraction.step.ForwardFrom(triple, {}, add);
  }
  const OneStep::Alive alive = [&](const rdf::Triple& triple) {
    return !retracted.deleted.contains(triple);
  };
  for (const rdf::Triple& triple : retracted.deleted) {
    bool follows = false;
    retraction.step.BackwardTo(triple, alive, [&](std::span<const rdf::Triple>) {
      follows = true;
      return false;
    });
    if (follows) retracted.restored.push_back(triple);
    if (retraction.step.gave_up()) break;
  }
  return retracted;
}

Retracted BackwardForward(const Retraction& retraction) {
  Retracted retracted;
  Provability provability(retraction, retracted.deleted);
  std::vector<rdf::Triple> open(retraction.taken_back.begin(), retraction.taken_back.end());
  TripleSet seen(open.begin(), open.end());
  const OneStep::VisitConclusion add = [&](const rdf::Triple& triple) {
    if (!seen.contains(triple) && retraction.is_in_layer(triple) &&
        !retraction.stays_asserted(triple)) {
      seen.insert(triple);
      open.push_back(triple);
    }
    return true;
  };
  while (!open.empty() && !retraction.step.gave_up()) {
    const rdf::Triple triple = open.back();
    open.pop_back();
    if (provability.Check(triple)) continue;
    retracted.deleted.insert(triple);
    retraction.step.ForwardFrom(triple, {}, add);
  }
  return retracted;
}

}  // namespace lares::owl
