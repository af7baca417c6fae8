#include "reasoner/owl/why_not.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "reasoner/owl/derivations.h"

namespace lares::owl {
namespace {

constexpr std::size_t kMaxMatches = 32;  // of one pattern that are followed
constexpr std::size_t kMaxParts = 4;     // ways of one missing premise that are combined

using Key = std::vector<std::tuple<bool, std::uint32_t, bool, std::uint32_t, bool, std::uint32_t>>;

Key KeyOf(const Lack& lack) {
  Key key;
  for (const Atom& a : lack.missing) {
    key.emplace_back(a.subject.is_variable, a.subject.value, a.predicate.is_variable,
                     a.predicate.value, a.object.is_variable, a.object.value);
  }
  std::sort(key.begin(), key.end());
  return key;
}

bool Nearer(const Lack& a, const Lack& b) {
  return std::tuple(a.missing.size(), b.near, a.rules.size()) <
         std::tuple(b.missing.size(), a.near, b.rules.size());
}

class Search {
 public:
  Search(const rdf::View& view, const WhyNotOptions& options)
      : view_(view), options_(options), derivations_(view) {}

  std::vector<Lack> Ways(const rdf::Triple& goal, std::size_t depth) {
    std::vector<Lack> ways;
    if (depth > options_.max_depth || !open_goals_.insert(goal).second) return ways;
    const auto [s, p, o] = goal;
    derivations_.ForEachBody({s, p, o}, [&](const Derivations::Body& body) {
      if (work_ > options_.max_work) return false;
      if (body.rule.name.starts_with("eq-") || body.rule.data.empty()) return true;
      Lack way;
      way.rules.push_back(body.rule.name);
      way.held.assign(body.premises.begin(), body.premises.end());
      Complete(body.rule, 0, body.binding, way, [&](const Lack& found) {
        for (Lack& lack : TakenApart(found, depth)) ways.push_back(std::move(lack));
      });
      return true;
    });
    open_goals_.erase(goal);
    Choose(&ways);
    return ways;
  }

 private:
  void Work() {
    if (++work_ % 256 == 0 && options_.stop.stop_requested()) {
      throw Error(Code::kTimeout, "stopped while looking for what is missing");
    }
  }

  // Each pattern of the body, in order, is matched or taken as missing.
  template <typename Found>
  void Complete(const Rule& rule, std::size_t position, const std::vector<rdf::TermId>& binding,
                const Lack& way, const Found& found) {
    Work();
    if (work_ > options_.max_work) return;
    if (position == rule.data.size()) {
      if (!way.missing.empty()) found(Renumbered(way, binding));
      return;
    }
    const Atom& atom = rule.data[position];
    const rdf::Pattern pattern = atom.In(binding);
    if (pattern.predicate == derivations_.words().type &&
        pattern.object == derivations_.words().thing) {
      return Complete(rule, position + 1, binding, way, found);
    }
    std::size_t matches = 0;
    view_.ForEach(pattern, [&](const rdf::Triple& triple) {
      Lack longer = way;
      longer.held.push_back(triple);
      ++longer.near;
      std::vector<rdf::TermId> bound = binding;
      const auto bind = [&](const Slot& slot, rdf::TermId value) {
        if (slot.is_variable) bound[slot.value] = value;
      };
      bind(atom.subject, triple.subject);
      bind(atom.predicate, triple.predicate);
      bind(atom.object, triple.object);
      Complete(rule, position + 1, bound, longer, found);
      return ++matches < kMaxMatches;
    });
    const bool is_ground = pattern.subject != rdf::kAnyTerm && pattern.object != rdf::kAnyTerm;
    if ((is_ground && matches > 0) || way.missing.size() == options_.max_missing) return;
    if (pattern.subject != rdf::kAnyTerm &&
        view_.dictionary().Kind(pattern.subject) == rdf::TermKind::kLiteral) {
      return;
    }
    Lack longer = way;
    longer.missing.push_back(atom);
    Complete(rule, position + 1, binding, longer, found);
  }

  // What is known of the variables filled in, the others given numbers of their own.
  Lack Renumbered(Lack way, const std::vector<rdf::TermId>& binding) {
    std::vector<std::uint32_t> numbers(binding.size(), 0);
    const auto fill = [&](Slot& slot) {
      if (!slot.is_variable) return;
      if (binding[slot.value] != rdf::kAnyTerm) {
        slot = {false, static_cast<std::uint32_t>(binding[slot.value])};
        return;
      }
      if (numbers[slot.value] == 0) numbers[slot.value] = ++variables_;
      slot.value = numbers[slot.value];
    };
    for (Atom& atom : way.missing) {
      fill(atom.subject);
      fill(atom.predicate);
      fill(atom.object);
    }
    return way;
  }

  // `way` with what is missing replaced by what that lacks in turn.
  std::vector<Lack> TakenApart(const Lack& way, std::size_t depth) {
    std::vector<Lack> wholes = {way};
    wholes.front().missing.clear();
    for (const Atom& atom : way.missing) {
      std::vector<Lack> parts;
      const bool is_ground =
          !atom.subject.is_variable && !atom.predicate.is_variable && !atom.object.is_variable;
      const rdf::Triple triple{rdf::TermId{atom.subject.value}, rdf::TermId{atom.predicate.value},
                               rdf::TermId{atom.object.value}};
      const bool is_anonymous = is_ground && triple.predicate == derivations_.words().type &&
                                view_.dictionary().Kind(triple.object) == rdf::TermKind::kBlank;
      if (is_ground) parts = Ways(triple, depth + 1);
      if (!is_anonymous) {
        std::erase_if(parts, [](const Lack& part) { return part.near == 0; });
        Lack itself;
        itself.missing.push_back(atom);
        parts.insert(parts.begin(), std::move(itself));
      }
      if (parts.size() > kMaxParts) parts.resize(kMaxParts);
      std::vector<Lack> longer;
      for (const Lack& whole : wholes) {
        for (const Lack& part : parts) {
          if (whole.missing.size() + part.missing.size() > options_.max_missing) continue;
          longer.push_back(Joined(whole, part));
        }
      }
      wholes = std::move(longer);
    }
    return wholes;
  }

  static Lack Joined(Lack whole, const Lack& part) {
    whole.missing.insert(whole.missing.end(), part.missing.begin(), part.missing.end());
    whole.held.insert(whole.held.end(), part.held.begin(), part.held.end());
    whole.rules.insert(whole.rules.end(), part.rules.begin(), part.rules.end());
    whole.near += part.near;
    return whole;
  }

  void Choose(std::vector<Lack>* ways) const {
    std::stable_sort(ways->begin(), ways->end(), Nearer);
    std::set<Key> seen;
    std::erase_if(*ways, [&](const Lack& way) { return !seen.insert(KeyOf(way)).second; });
    if (ways->size() > options_.max_lacks) ways->resize(options_.max_lacks);
  }

  const rdf::View& view_;
  const WhyNotOptions& options_;
  Derivations derivations_;
  std::set<rdf::Triple> open_goals_;
  std::size_t work_ = 0;
  std::uint32_t variables_ = 0;
};

}  // namespace

std::vector<Lack> WhyNot(const rdf::View& view, const rdf::Triple& goal,
                         const WhyNotOptions& options) {
  if (auto axioms = WhyNoAxiom(view, goal)) return *axioms;
  return Search(view, options).Ways(goal, 1);
}

}  // namespace lares::owl
