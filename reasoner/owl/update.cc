#include "reasoner/owl/update.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "ontology/triples/sorting.h"
#include "reasoner/owl/retract.h"
#include "reasoner/owl/values.h"

namespace lares::owl {
namespace {

using Triples = std::vector<rdf::Triple>;

bool IsIn(const Triples& sorted, const rdf::Triple& triple) {
  return std::binary_search(sorted.begin(), sorted.end(), triple);
}

Triples Minus(const Triples& sorted, const Triples& other) {
  Triples rest;
  std::set_difference(sorted.begin(), sorted.end(), other.begin(), other.end(),
                      std::back_inserter(rest));
  return rest;
}

Triples Union(const std::vector<rdf::Graph>& graphs) {
  Triples all;
  for (const rdf::Graph& graph : graphs) {
    all.insert(all.end(), graph.triples.begin(), graph.triples.end());
  }
  rdf::SortAndDeduplicate(all);
  return all;
}

Triples StoredIn(const rdf::View& layer) {
  Triples all;
  layer.ForEachStored({}, [&](const rdf::Triple& triple) {
    all.push_back(triple);
    return true;
  });
  rdf::SortAndDeduplicate(all);
  return all;
}

using ClashKey = std::pair<std::string, Triples>;
ClashKey KeyOf(const rdf::Clash& clash) {
  Triples premises = clash.premises;
  std::sort(premises.begin(), premises.end());
  return {clash.rule, std::move(premises)};
}

// One step from a layer to its successor.
class Change {
 public:
  Change(const rdf::View& below, const rdf::Layer& before, const std::vector<rdf::Graph>& after,
         const Options& options, std::stop_token stop)
      : below_(below),
        before_(before),
        // Borrowed: this object does not outlive the call.
        layer_(rdf::View(below.shared_dictionary())
                   .With(std::shared_ptr<const rdf::Layer>(std::shared_ptr<void>(), &before))),
        whole_(below.With(std::shared_ptr<const rdf::Layer>(std::shared_ptr<void>(), &before))),
        options_(options),
        stop_(std::move(stop)),
        words_(below.dictionary()),
        asserted_(Union(after)) {
    const Triples asserted_before = Union(before.graphs());
    for (const rdf::Triple& triple : Minus(asserted_before, asserted_)) {
      if (layer_.Contains(triple)) removed_.push_back(triple);
    }
    added_ = Minus(asserted_, asserted_before);
    std::erase_if(added_, [&](const rdf::Triple& triple) { return below_.Contains(triple); });
  }

  // Nothing where recomputation is needed or cheaper.
  std::optional<rdf::Inference> Run() {
    if (NeedsRecomputation()) return std::nullopt;
    std::optional<Retracted> outcome = removed_.empty() ? Retracted() : Retract();
    if (!outcome) return std::nullopt;
    Retracted& retracted = *outcome;
    Triples kept = StoredIn(layer_);
    std::erase_if(kept, [&](const auto& triple) { return retracted.deleted.contains(triple); });
    rdf::Inference inference;
    KeepClashes(retracted.deleted, inference);
    Triples fresh = std::move(retracted.restored);
    fresh.insert(fresh.end(), added_.begin(), added_.end());
    if (!fresh.empty() && !Add(kept, retracted.deleted.empty(), std::move(fresh), inference)) {
      return std::nullopt;
    }
    inference.inferred = Minus(kept, asserted_);
    if (inference.inferred.size() > options_.max_inferred) {
      throw Error(Code::kTooLarge,
                  "more than " + std::to_string(options_.max_inferred) + " triples follow");
    }
    if (!below_.layers().empty()) {
      std::copy_if(asserted_.begin(), asserted_.end(), std::back_inserter(inference.held_below),
                   [&](const rdf::Triple& triple) { return below_.Contains(triple); });
    }
    return inference;
  }

 private:
  bool NeedsRecomputation() const {
    const auto is_equality = [&](const auto& triple) { return triple.predicate == words_.same_as; };
    // A cell at a list of the layers below: what that list said alone is said anew with it.
    const auto extends_list_below = [&](const rdf::Triple& triple) {
      return (triple.predicate == words_.first || triple.predicate == words_.rest) &&
             (below_.Estimate({triple.subject, {}, {}}) > 0 ||
              below_.Estimate({{}, {}, triple.subject}) > 0);
    };
    if (before_.clash_count() > before_.clashes().size()) return true;
    if (added_.size() >= std::max<std::size_t>(before_.size(), 1)) return true;
    if (std::any_of(added_.begin(), added_.end(), is_equality)) return true;
    if (whole_.equality() != nullptr) return true;
    if (removed_.empty()) return false;
    return 2 * removed_.size() >= asserted_.size() || DependsOnValues(whole_) ||
           std::any_of(removed_.begin(), removed_.end(), extends_list_below);
  }

  // Nothing when it would cost more than to begin anew: a step costs about a third of what the
  // engine spends on a triple.
  std::optional<Retracted> Retract() const {
    OneStep step(whole_, 1000 + 3 * before_.size(), stop_);
    return DeleteAndRederive({step,
                              [&](const rdf::Triple& triple) { return layer_.Contains(triple); },
                              [&](const rdf::Triple& triple) { return IsIn(asserted_, triple); },
                              removed_, 1000 + before_.size() / 4});
  }

  void KeepClashes(const TripleSet& deleted, rdf::Inference& inference) const {
    for (const rdf::Clash& clash : before_.clashes()) {
      const bool stands =
          std::none_of(clash.premises.begin(), clash.premises.end(),
                       [&](const auto& premise) { return deleted.contains(premise); });
      if (stands) inference.clashes.push_back(clash);
    }
    inference.clash_count = inference.clashes.size();
  }

  // Closes `kept` with `fresh`; false when that makes things equal that were not.
  bool Add(Triples& kept, bool kept_is_before, Triples fresh, rdf::Inference& inference) const {
    rdf::View standing = whole_;
    if (!kept_is_before) {
      standing = below_.With(std::make_shared<const rdf::Layer>(
          std::vector<rdf::Graph>{}, rdf::Inference{kept, {}, 0, {}, {}}, &below_.dictionary()));
    }
    std::vector<rdf::Graph> graphs(1);
    rdf::SortAndDeduplicate(fresh);
    graphs[0].triples = std::move(fresh);
    const auto more = Materialise(standing, std::move(graphs), options_, stop_);
    const rdf::View added = rdf::View(below_.shared_dictionary()).With(more);
    if (more->equality() != nullptr) return false;
    const Triples stored = StoredIn(added);
    const auto middle = static_cast<std::ptrdiff_t>(kept.size());
    kept.insert(kept.end(), stored.begin(), stored.end());
    std::inplace_merge(kept.begin(), kept.begin() + middle, kept.end());
    AddClashes(*more, inference);
    return true;
  }

  void AddClashes(const rdf::Layer& more, rdf::Inference& inference) const {
    std::set<ClashKey> known;
    for (const rdf::Clash& clash : inference.clashes) known.insert(KeyOf(clash));
    inference.clash_count += more.clash_count();
    for (const rdf::Clash& clash : more.clashes()) {
      if (!known.insert(KeyOf(clash)).second) {
        --inference.clash_count;
      } else if (inference.clashes.size() < options_.max_clashes) {
        inference.clashes.push_back(clash);
      }
    }
  }

  const rdf::View& below_;
  const rdf::Layer& before_;
  const rdf::View layer_, whole_;
  Options options_;
  std::stop_token stop_;
  const Vocabulary words_;
  const Triples asserted_;  // after
  Triples removed_, added_;
};

}  // namespace

std::shared_ptr<const rdf::Layer> Update(const rdf::View& below, const rdf::Layer& before,
                                         std::vector<rdf::Graph> graphs_after,
                                         const Options& options, std::stop_token stop) {
  std::optional<rdf::Inference> inference =
      Change(below, before, graphs_after, options, stop).Run();
  if (!inference) return Materialise(below, std::move(graphs_after), options, std::move(stop));
  return std::make_shared<const rdf::Layer>(std::move(graphs_after), std::move(*inference),
                                            &below.dictionary());
}

}  // namespace lares::owl
