// Terms that turn out to be the same.
#include "reasoner/owl/engine.h"

namespace lares::owl {

void Engine::JoinPendingClasses() {
  std::vector<std::pair<rdf::TermId, rdf::TermId>> pending;
  pending.swap(pending_classes_);
  for (const auto& [a, b] : pending) JoinClasses(a, b);
}

void Engine::JoinClasses(rdf::TermId a, rdf::TermId b) {
  Step();
  const std::vector<rdf::TermId> moved = equality_.Merge(a, b);
  if (moved.empty()) return;
  has_new_equality_ = true;
  for (const rdf::TermId term : moved) RewriteTriplesOf(term);
  const rdf::TermId representative = equality_.Representative(moved.front());
  const bool was_alone = equality_.Members(representative).size() == moved.size() + 1;
  if (was_alone) ConcludeReflexive(representative);
  // For rules that look at sameness itself: every pair of the class, by representatives.
  facts_.Add({representative, words_.same_as, representative}, kHidden);
  CheckValuesOf(representative);
}

// The triples that name `term`, which represents itself no longer, as they are now.
void Engine::RewriteTriplesOf(rdf::TermId term) {
  std::vector<rdf::Triple> old;
  for (const rdf::Pattern& pattern :
       {rdf::Pattern{term, {}, {}}, rdf::Pattern{{}, term, {}}, rdf::Pattern{{}, {}, term}}) {
    facts_.ForEach(pattern, [&](const rdf::Triple& triple) { old.push_back(triple); });
    below_.ForEachStored(pattern, [&](const rdf::Triple& triple) {
      old.push_back(triple);
      return true;
    });
  }
  for (const rdf::Triple& triple : old) Derive(triple, kRewritten);
}

// c ⊑ c was trivial as long as c had one name; now it says that its names mean one class, so what
// concludes it is looked at again.
void Engine::ConcludeReflexive(rdf::TermId term) {
  std::vector<rdf::Triple> schema;
  for (const rdf::Triple& triple : Match({term, {}, {}})) {
    if (IsSchema(triple)) schema.push_back(triple);
  }
  for (const rdf::Triple& triple : schema) {
    FireKey({KeyKind::kPredicate, triple.predicate}, triple, 0);
    const bool is_order =
        triple.predicate == words_.sub_class_of || triple.predicate == words_.sub_property_of;
    // A circle that its TransitiveClosure knows already.
    if (is_order && Knows({triple.object, triple.predicate, term})) {
      Derive({term, triple.predicate, term}, kRewritten);
    }
  }
}

}  // namespace lares::owl
