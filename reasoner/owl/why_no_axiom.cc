// Axioms do not follow from data: what is missing is an axiom, and how near the known ones come.
#include <algorithm>
#include <set>

#include "reasoner/owl/why_not.h"

namespace lares::owl {
namespace {

using rdf::TermId;
using rdf::Triple;

constexpr std::size_t kMaxClasses = 3;  // told of one kind

Slot SlotOf(TermId term) { return {false, static_cast<std::uint32_t>(term)}; }

class Classes {
 public:
  explicit Classes(const rdf::View& view) : view_(view), words_(view.dictionary()) {}

  const Vocabulary& words() const { return words_; }

  std::vector<Lack> WhyNotBelow(TermId low, TermId high) const {
    std::vector<Lack> lacks(1);
    Lack& itself = lacks.front();
    itself.missing = {Below(low, high)};
    if (IsBelow(high, low)) itself.held.push_back({high, words_.sub_class_of, low});
    const std::set<TermId> above_low = Above(low), above_high = Above(high);
    std::vector<TermId> common, others;
    for (const TermId name : above_low) {
      (above_high.contains(name) ? common : others).push_back(name);
    }
    // The nearest to both: with no other of them below.
    for (const TermId name : Outermost(common, [&](TermId a, TermId b) { return IsBelow(a, b); })) {
      if (name == high || name == low) continue;
      itself.held.push_back({low, words_.sub_class_of, name});
      itself.held.push_back({high, words_.sub_class_of, name});
    }
    std::erase_if(others, [&](TermId name) { return name == low || IsBelow(name, low); });
    // The nearest to `high`: right below what is above both.
    for (const TermId name : Outermost(others, [&](TermId a, TermId b) { return IsBelow(b, a); })) {
      lacks.push_back({{Below(name, high)}, {{low, words_.sub_class_of, name}}, {"scm-sco"}, 0});
    }
    return lacks;
  }

 private:
  Atom Below(TermId low, TermId high) const {
    return {SlotOf(low), SlotOf(words_.sub_class_of), SlotOf(high)};
  }
  bool IsBelow(TermId low, TermId high) const {
    return view_.Contains({low, words_.sub_class_of, high});
  }

  // The named classes above one, and itself; but owl:Thing.
  std::set<TermId> Above(TermId name) const {
    std::set<TermId> above = {name};
    for (const TermId super : view_.Objects(name, words_.sub_class_of)) {
      if (super == words_.thing || view_.dictionary().Kind(super) != rdf::TermKind::kIri) continue;
      above.insert(super);
    }
    return above;
  }

  // Those that no other one precedes; equivalent ones do not precede each other.
  template <typename Precedes>
  std::vector<TermId> Outermost(const std::vector<TermId>& names, const Precedes& precedes) const {
    std::vector<TermId> chosen;
    for (const TermId name : names) {
      const bool is_preceded = std::any_of(names.begin(), names.end(), [&](TermId other) {
        return other != name && precedes(other, name) && !precedes(name, other);
      });
      if (!is_preceded && chosen.size() < kMaxClasses) chosen.push_back(name);
    }
    return chosen;
  }

  const rdf::View& view_;
  Vocabulary words_;
};

}  // namespace

std::optional<std::vector<Lack>> WhyNoAxiom(const rdf::View& view, const Triple& goal) {
  const Classes classes(view);
  const Vocabulary& words = classes.words();
  const auto [s, p, o] = goal;
  if (p == words.sub_class_of) return classes.WhyNotBelow(s, o);
  const TermId others[] = {words.sub_property_of, words.equivalent_class, words.equivalent_property,
                           view.dictionary().InternIri(Expand("rdfs:domain")),
                           view.dictionary().InternIri(Expand("rdfs:range"))};
  if (std::find(std::begin(others), std::end(others), p) == std::end(others)) return std::nullopt;
  Lack itself;
  itself.missing = {{SlotOf(s), SlotOf(p), SlotOf(o)}};
  for (const TermId below : {words.sub_class_of, words.sub_property_of}) {
    const bool is_half =
        p == (below == words.sub_class_of ? words.equivalent_class : words.equivalent_property);
    for (const Triple& half : {Triple{s, below, o}, Triple{o, below, s}}) {
      if (is_half && view.Contains(half)) itself.held.push_back(half);
    }
  }
  return std::vector<Lack>{itself};
}

}  // namespace lares::owl
