#include "reasoner/authority/authority.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/authority/axioms.h"
#include "reasoner/authority/structure.h"

namespace lares::authority {
namespace {

constexpr int kMaxDepth = 100;  // of nested expressions; a list's length does not count

class Judge {
 public:
  Judge(const rdf::View& known, const rdf::Graph& graph, const Owners& owners,
        const JudgeOptions& options)
      : known_(known),
        graph_(graph),
        owners_(owners),
        options_(options),
        table_(known.dictionary()),
        match_(known, graph) {
    FindOpenClasses();
  }

  std::vector<Trespass> Find() {
    std::vector<Trespass> found;
    for (const rdf::Triple& triple : graph_.triples) {
      for (const rdf::TermId term : TermsThatItAddsTo(triple)) {
        if (SaysNoMoreThanAKind(triple) || Describes(triple) || IsKnown(triple)) break;
        found.push_back({triple, term, owners_.OwnersOf(term)});
      }
    }
    return found;
  }

 private:
  bool IsBlank(rdf::TermId term) const {
    return known_.dictionary().Kind(term) == rdf::TermKind::kBlank;
  }
  // A named term that others own, and this document does not.
  bool IsOthers(rdf::TermId term) const {
    if (known_.dictionary().Kind(term) != rdf::TermKind::kIri || table_.IsBuiltIn(term)) {
      return false;
    }
    const std::vector<std::string> owners = owners_.OwnersOf(term);
    return !owners.empty() && std::count(owners.begin(), owners.end(), graph_.name) == 0;
  }

  std::vector<rdf::Triple> Below(rdf::TermId subject) const {
    const auto& triples = graph_.triples;
    std::vector<rdf::Triple> below;
    for (auto at = std::lower_bound(triples.begin(), triples.end(),
                                    rdf::Triple{subject, rdf::kAnyTerm, rdf::kAnyTerm});
         at != triples.end() && at->subject == subject; ++at) {
      below.push_back(*at);
    }
    return below;
  }
  std::vector<rdf::TermId> Members(rdf::TermId list) const {
    std::vector<rdf::TermId> members;
    for (std::size_t cells = 0; list != table_.nil && cells <= graph_.triples.size(); ++cells) {
      rdf::TermId next = table_.nil;
      for (const rdf::Triple& triple : Below(list)) {
        if (triple.predicate == table_.first) members.push_back(triple.object);
        if (triple.predicate == table_.rest) next = triple.object;
      }
      list = next;
    }
    return members;
  }

  // Whether something can be an instance of `term` without being said to be anything of this
  // document's own.
  bool IsOfOthers(rdf::TermId term, int depth = 0) const {
    if (!IsBlank(term)) {
      return IsOthers(term) || term == table_.thing || causes_.count(term) != 0;
    }
    if (causes_.count(term) != 0) return true;
    if (depth > kMaxDepth) return true;
    for (const rdf::Triple& part : Below(term)) {
      if (!table_.IsExpressionPart(part.predicate) || IsLiteral(part.object)) continue;
      const bool is_union = part.predicate == table_.union_of;
      const auto of_others = [&](rdf::TermId other) { return IsOfOthers(other, depth + 1); };
      if (IsList(part.object)) {
        const std::vector<rdf::TermId> members = Members(part.object);
        const bool holds = is_union ? std::any_of(members.begin(), members.end(), of_others)
                                    : std::all_of(members.begin(), members.end(), of_others);
        if (!holds) return false;
      } else if (!of_others(part.object)) {
        return false;
      }
    }
    return true;
  }
  bool IsLiteral(rdf::TermId term) const {
    return known_.dictionary().Kind(term) == rdf::TermKind::kLiteral;
  }
  bool IsList(rdf::TermId term) const {
    if (!IsBlank(term)) return false;
    const std::vector<rdf::Triple> below = Below(term);
    return std::any_of(below.begin(), below.end(),
                       [&](const rdf::Triple& part) { return part.predicate == table_.first; });
  }

  std::vector<rdf::TermId> TermsThatItAddsTo(const rdf::Triple& triple) const {
    const auto [s, p, o] = triple;
    std::vector<rdf::TermId> terms;
    const auto add = [&](rdf::TermId term) {
      if (IsOthers(term)) terms.push_back(term);
    };
    switch (table_.WeightOf(triple)) {
      case Weight::kNone:
        break;
      case Weight::kDeclaration:
        if (IsOthers(s) && ChangesKind(triple)) terms.push_back(s);
        break;
      case Weight::kSubject:
        add(s);
        if (terms.empty() && p == table_.sub_class_of) terms = AddedThroughOpenClass(s, o);
        if (terms.empty() && p == table_.intersection_of && !IsOnlyCause(s, o)) {
          for (const rdf::TermId member : Members(o)) add(member);
        }
        break;
      case Weight::kBoth:
        add(s);
        if (o != s) add(o);
        if (terms.empty() && p == table_.equivalent_class) {
          terms = AddedThroughOpenClass(s, o);
          if (terms.empty()) terms = AddedThroughOpenClass(o, s);
        }
        break;
      case Weight::kExclusion:
        if (IsOfOthers(s) && IsOfOthers(o)) {
          std::unordered_set<rdf::TermId> seen;
          AddTermsBehind(s, seen, terms);
          AddTermsBehind(o, seen, terms);
        }
        break;
      case Weight::kMembers: {
        std::vector<rdf::TermId> others = Members(o);
        std::erase_if(others, [&](rdf::TermId member) { return !IsOfOthers(member); });
        if (others.size() < 2) break;
        std::unordered_set<rdf::TermId> seen;
        for (const rdf::TermId member : others) AddTermsBehind(member, seen, terms);
        break;
      }
      case Weight::kUnion:
        add(s);
        if (IsBlank(s)) break;
        for (const rdf::TermId member : Members(o)) add(member);
        break;
    }
    return terms;
  }

  // What makes a class of this document hold of things that are said to be nothing but what others
  // have terms for: expressions and classes that are below it. Such a class is open: what is said
  // of it is said of them.
  void FindOpenClasses() {
    for (bool grew = true; grew;) {
      grew = false;
      for (const rdf::Triple& triple : graph_.triples) {
        const auto [s, p, o] = triple;
        if (p == table_.sub_class_of || p == table_.equivalent_class) grew |= Open(s, o);
        if (p == table_.equivalent_class) grew |= Open(o, s);
        if (!IsBlank(s) && (p == table_.intersection_of || p == table_.union_of)) {
          grew |= OpenByList(triple);
        }
      }
    }
  }
  bool Open(rdf::TermId cause, rdf::TermId term) {
    if (cause == term || IsOthers(term) || IsLiteral(term) || table_.IsBuiltIn(term) ||
        !IsOfOthers(cause)) {
      return false;
    }
    return causes_[term].insert(cause).second;
  }
  // A named intersection or union: its list is its cause.
  bool OpenByList(const rdf::Triple& part) {
    if (IsOthers(part.subject)) return false;
    const std::vector<rdf::TermId> members = Members(part.object);
    const auto of_others = [&](rdf::TermId member) { return IsOfOthers(member); };
    const bool holds = part.predicate == table_.union_of
                           ? std::any_of(members.begin(), members.end(), of_others)
                           : std::all_of(members.begin(), members.end(), of_others);
    return holds && causes_[part.subject].insert(part.object).second;
  }
  bool IsOpen(rdf::TermId term) const {
    return IsBlank(term) ? !Below(term).empty() && IsOfOthers(term) : causes_.count(term) != 0;
  }

  // Whether "term ⊑ above" says nothing new of what makes `term` open: each cause is `above` itself
  // or has a conjunct that is known to be below it.
  bool IsImpliedByCauses(rdf::TermId term, rdf::TermId above) const {
    std::unordered_set<rdf::TermId> causes;
    if (const auto found = causes_.find(term); found != causes_.end()) causes = found->second;
    if (IsBlank(term)) causes.insert(term);
    return std::all_of(causes.begin(), causes.end(), [&](rdf::TermId cause) {
      return cause == above || IsConjunct(cause, above);
    });
  }
  bool IsOnlyCause(rdf::TermId term, rdf::TermId cause) const {
    const auto found = causes_.find(term);
    return IsBlank(term) || found == causes_.end() ||
           (found->second.size() == 1 && found->second.count(cause) != 0);
  }
  bool IsConjunct(rdf::TermId expression, rdf::TermId above) const {
    const std::vector<rdf::Triple> parts = Below(expression);
    return std::any_of(parts.begin(), parts.end(), [&](const rdf::Triple& part) {
      if (part.predicate != table_.intersection_of) return false;
      const std::vector<rdf::TermId> members = Members(part.object);
      return std::any_of(members.begin(), members.end(), [&](rdf::TermId member) {
        return member == above || known_.Contains({member, table_.sub_class_of, above});
      });
    });
  }
  // Terms of others that an open class rests on, or that are there to be added to: never empty for
  // an open class.
  void AddTermsBehind(rdf::TermId term, std::unordered_set<rdf::TermId>& seen,
                      std::vector<rdf::TermId>& terms) const {
    if (!seen.insert(term).second) return;
    for (const rdf::TermId name : NamesIn(term)) {
      if (IsOthers(name)) terms.push_back(name);
      const auto causes = causes_.find(name);
      if (causes == causes_.end()) continue;
      for (const rdf::TermId cause : causes->second) AddTermsBehind(cause, seen, terms);
    }
  }
  // "term ⊑ above", where the term is of this document.
  std::vector<rdf::TermId> AddedThroughOpenClass(rdf::TermId term, rdf::TermId above) const {
    std::vector<rdf::TermId> terms;
    const bool above_is_own = !IsBlank(above) && !IsOthers(above);
    if (above_is_own || !IsOpen(term) || IsImpliedByCauses(term, above)) return terms;
    for (const rdf::TermId name : NamesIn(above)) {
      if (IsOthers(name)) terms.push_back(name);
    }
    return terms;
  }

  // The named classes and properties of an expression; a name itself.
  std::vector<rdf::TermId> NamesIn(rdf::TermId term, int depth = 0) const {
    if (!IsBlank(term)) return {term};
    std::vector<rdf::TermId> names;
    if (depth > kMaxDepth) return names;
    for (const rdf::Triple& part : Below(term)) {
      const bool is_cell = part.predicate == table_.first || part.predicate == table_.rest;
      if (IsLiteral(part.object) || !(is_cell || table_.IsExpressionPart(part.predicate))) continue;
      for (const rdf::TermId name : NamesIn(part.object, depth + 1)) names.push_back(name);
    }
    return names;
  }

  // A class of others becomes a property, or the other way round.
  bool ChangesKind(const rdf::Triple& triple) const {
    bool is_class = false;
    bool is_property = false;
    for (const rdf::TermId kind : known_.Objects(triple.subject, table_.type)) {
      is_class = is_class || table_.MakesClasses(kind);
      is_property = is_property || table_.MakesProperties(kind);
    }
    return table_.MakesClasses(triple.object) ? is_property && !is_class : is_class && !is_property;
  }

  // C ⊑ C, and axioms from which nothing follows but declarations, which anybody may make: a range
  // of owl:Class, a superclass owl:Thing.
  bool SaysNoMoreThanAKind(const rdf::Triple& triple) const {
    const Weight weight = table_.WeightOf(triple);
    if (triple.subject == triple.object) return weight != Weight::kExclusion;
    if (weight != Weight::kSubject || triple.predicate == table_.type) return false;
    return triple.object == table_.thing || table_.MakesClasses(triple.object) ||
           table_.MakesProperties(triple.object);
  }

  // C ⊑ [some values, a value], where the document is there to describe C.
  bool Describes(const rdf::Triple& triple) const {
    if (triple.predicate != table_.sub_class_of || !IsBlank(triple.object) ||
        options_.described.count(triple.subject) == 0) {
      return false;
    }
    const std::vector<rdf::Triple> parts = Below(triple.object);
    return std::all_of(parts.begin(), parts.end(), [&](const rdf::Triple& part) {
      return part.predicate == table_.type || part.predicate == table_.on_property ||
             part.predicate == table_.some_values_from || part.predicate == table_.has_value;
    });
  }

  bool IsKnown(const rdf::Triple& triple) {
    if (match_.Holds(triple)) return true;
    return table_.WeightOf(triple) == Weight::kMembers && IsPartOfKnownList(triple);
  }

  // Some list of the same predicate and kind has all of the members: what excludes more excludes
  // these.
  bool IsPartOfKnownList(const rdf::Triple& triple) const {
    const std::vector<rdf::TermId> wanted = Members(triple.object);
    for (const rdf::Triple& other : known_.Match({{}, triple.predicate, {}})) {
      if (!HaveOneType(triple.subject, other.subject)) continue;
      const std::unordered_set<rdf::TermId> have = KnownMembers(other.object);
      if (std::all_of(wanted.begin(), wanted.end(),
                      [&](rdf::TermId member) { return have.count(member) != 0; })) {
        return true;
      }
    }
    return false;
  }
  bool HaveOneType(rdf::TermId node, rdf::TermId known) const {
    const std::vector<rdf::Triple> parts = Below(node);
    return std::any_of(parts.begin(), parts.end(), [&](const rdf::Triple& part) {
      return part.predicate == table_.type && known_.Contains({known, table_.type, part.object});
    });
  }
  std::unordered_set<rdf::TermId> KnownMembers(rdf::TermId list) const {
    std::unordered_set<rdf::TermId> members;
    std::unordered_set<rdf::TermId> cells;
    while (list != table_.nil && cells.insert(list).second) {
      for (const rdf::TermId member : known_.Objects(list, table_.first)) members.insert(member);
      const std::vector<rdf::TermId> next = known_.Objects(list, table_.rest);
      if (next.size() != 1) break;
      list = next.front();
    }
    return members;
  }

  const rdf::View& known_;
  const rdf::Graph& graph_;
  const Owners& owners_;
  const JudgeOptions& options_;
  AxiomTable table_;
  StructureMatch match_;
  std::unordered_map<rdf::TermId, std::unordered_set<rdf::TermId>> causes_;  // of open classes
};

}  // namespace

std::vector<Trespass> FindTrespasses(const rdf::View& known, const rdf::Graph& graph,
                                     const Owners& owners, const JudgeOptions& options) {
  return Judge(known, graph, owners, options).Find();
}

std::unordered_set<rdf::TermId> ModelledClasses(const rdf::Graph& graph,
                                                rdf::Dictionary& dictionary) {
  const AxiomTable table(dictionary);
  const rdf::TermId provides = dictionary.InternIri(std::string(rdf::kLares) + "providesModelFor");
  std::unordered_map<rdf::TermId, std::vector<rdf::TermId>> above;  // class → its superclasses
  std::unordered_map<rdf::TermId, std::vector<rdf::TermId>> fillers;
  std::vector<rdf::TermId> open;
  for (const rdf::Triple& triple : graph.triples) {
    if (triple.predicate == provides) open.push_back(triple.object);
    if (triple.predicate == table.sub_class_of) above[triple.subject].push_back(triple.object);
    if (triple.predicate == table.some_values_from) {
      fillers[triple.subject].push_back(triple.object);
    }
  }
  std::unordered_set<rdf::TermId> modelled;
  while (!open.empty()) {
    const rdf::TermId term = open.back();
    open.pop_back();
    if (!modelled.insert(term).second) continue;
    for (const rdf::TermId super : above[term]) {
      open.insert(open.end(), fillers[super].begin(), fillers[super].end());
    }
  }
  return modelled;
}

}  // namespace lares::authority
