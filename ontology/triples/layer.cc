#include <algorithm>
#include <iterator>

#include "ontology/triples/sorting.h"
#include "ontology/triples/view.h"

namespace lares::rdf {
namespace {

std::uint64_t Pair(TermId first, TermId second) {
  return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 |
         static_cast<std::uint32_t>(second);
}

// The run of `sorted` whose key is `key`. `key_of` is monotone over `sorted`.
template <typename Key, typename KeyOf>
std::span<const Triple> RunOf(std::span<const Triple> sorted, Key key, KeyOf key_of) {
  const auto below = [&](const Triple& triple) { return key_of(triple) < key; };
  const auto not_above = [&](const Triple& triple) { return !(key < key_of(triple)); };
  const auto begin = std::partition_point(sorted.begin(), sorted.end(), below);
  // Runs are short as a rule: gallop to an end before searching for it.
  std::size_t step = 1;
  auto end = begin;
  while (sorted.end() - end > static_cast<std::ptrdiff_t>(step) &&
         not_above(end[static_cast<std::ptrdiff_t>(step)])) {
    end += static_cast<std::ptrdiff_t>(step);
    step *= 2;
  }
  const auto limit = sorted.end() - end > static_cast<std::ptrdiff_t>(step)
                         ? end + static_cast<std::ptrdiff_t>(step)
                         : sorted.end();
  end = std::partition_point(end, limit, not_above);
  return {begin, end};
}

template <Component A>
std::span<const Triple> RunOfOne(std::span<const Triple> sorted, TermId a) {
  return RunOf(sorted, a, [](const Triple& triple) { return Get(triple, A); });
}

template <Component A, Component B>
std::span<const Triple> RunOfTwo(std::span<const Triple> sorted, TermId a, TermId b) {
  return RunOf(sorted, Pair(a, b),
               [](const Triple& triple) { return Pair(Get(triple, A), Get(triple, B)); });
}

std::vector<Triple> Union(const std::vector<Graph>& graphs) {
  std::vector<Triple> all;
  std::size_t count = 0;
  for (const Graph& graph : graphs) count += graph.triples.size();
  all.reserve(count);
  for (const Graph& graph : graphs) {
    all.insert(all.end(), graph.triples.begin(), graph.triples.end());
  }
  SortAndDeduplicate(all);
  return all;
}

// What representatives stand for is not stored beside them.
void DropImplied(const Equality& equality, std::vector<Triple>& triples) {
  std::erase_if(triples, [&](const Triple& triple) {
    if (!equality.IsNormal(triple)) return true;
    return triple.predicate == equality.same_as() && triple.subject == triple.object &&
           !equality.Members(triple.subject).empty();
  });
}

constexpr Component kS = Component::kSubject;
constexpr Component kP = Component::kPredicate;
constexpr Component kO = Component::kObject;

}  // namespace

Layer::Layer(std::vector<Graph> graphs, std::vector<Triple> inferred, std::vector<Clash> clashes)
    : Layer(std::move(graphs), Inference{std::move(inferred), std::move(clashes), 0, {}, nullptr}) {
}

Layer::Layer(std::vector<Graph> graphs, Inference inference, const Dictionary* dictionary)
    : graphs_(std::move(graphs)),
      clashes_(std::move(inference.clashes)),
      clash_count_(std::max(inference.clash_count, clashes_.size())),
      equality_(std::move(inference.equality)) {
  for (Graph& graph : graphs_) SortAndDeduplicate(graph.triples);
  if (graphs_.size() != 1) asserted_ = Union(graphs_);
  SortAndDeduplicate(inference.inferred);
  std::vector<Triple> fresh;  // asserted and not held below
  fresh.reserve(asserted().size());
  std::set_difference(asserted().begin(), asserted().end(), inference.held_below.begin(),
                      inference.held_below.end(), std::back_inserter(fresh));
  spo_.reserve(fresh.size() + inference.inferred.size());
  std::set_union(fresh.begin(), fresh.end(), inference.inferred.begin(), inference.inferred.end(),
                 std::back_inserter(spo_));
  fresh = {};
  inference.inferred = {};
  if (equality_ != nullptr) DropImplied(*equality_, spo_);
  if (dictionary != nullptr) {
    has_literal_subjects_ = std::any_of(spo_.begin(), spo_.end(), [&](const Triple& triple) {
      return dictionary->Kind(triple.subject) == TermKind::kLiteral;
    });
  }
  spo_.shrink_to_fit();
  for (const Triple& triple : spo_) {
    largest_ = std::max({largest_, triple.subject, triple.predicate, triple.object});
  }
  osp_ = spo_;
  StableSortBy(kO, osp_);
  pos_ = osp_;
  StableSortBy(kP, pos_);
}

std::size_t Layer::memory_bytes() const {
  std::size_t triples = spo_.capacity() + pos_.capacity() + osp_.capacity() + asserted_.capacity();
  std::size_t bytes = sizeof(Layer);
  for (const Graph& graph : graphs_) {
    triples += graph.triples.capacity();
    bytes += sizeof(Graph) + graph.name.size() + 48 * graph.as_written.size();
  }
  for (const Clash& clash : clashes_) {
    triples += clash.premises.capacity();
    bytes += sizeof(Clash) + clash.rule.size();
  }
  return bytes + triples * sizeof(Triple);
}

std::span<const Triple> Layer::Range(const Pattern& pattern) const {
  const auto [s, p, o] = pattern;
  if (std::max({s, p, o}) > largest_) return {};
  if (s != kAnyTerm && o != kAnyTerm && p == kAnyTerm) return RunOfTwo<kO, kS>(osp_, o, s);
  if (s != kAnyTerm) {
    if (p == kAnyTerm) return RunOfOne<kS>(spo_, s);
    const auto run = RunOfTwo<kS, kP>(spo_, s, p);
    return o == kAnyTerm ? run : RunOfOne<kO>(run, o);
  }
  if (p != kAnyTerm) {
    return o == kAnyTerm ? RunOfOne<kP>(pos_, p) : RunOfTwo<kP, kO>(pos_, p, o);
  }
  return o == kAnyTerm ? std::span<const Triple>(spo_) : RunOfOne<kO>(osp_, o);
}

bool Layer::Contains(const Triple& triple) const {
  if (std::max({triple.subject, triple.predicate, triple.object}) > largest_) return false;
  return std::binary_search(spo_.begin(), spo_.end(), triple);
}

bool Layer::IsAsserted(const Triple& triple) const {
  return std::binary_search(asserted().begin(), asserted().end(), triple);
}

}  // namespace lares::rdf
