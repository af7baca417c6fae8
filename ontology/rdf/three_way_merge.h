// Two documents that began as one, as one again.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ontology/rdf/document.h"

namespace lares::rdf {

// What both sides said differently of the same thing. Values are as N-Triples writes them; a blank
// node is written as what is said of it, in square brackets.
struct MergeConflict {
  std::string subject;    // IRI, or a blank node as above
  std::string predicate;  // IRI; empty: one side took the subject out, the other changed it
  std::vector<std::string> base, ours, theirs;
};

enum class Side { kOurs, kTheirs };

struct MergeResult {
  Document document;  // the merge; with conflicts: of all else, their subjects and values as ours
  std::vector<MergeConflict> conflicts;
};

// What either side added to `base` is added, what either took away is taken away. A predicate of a
// subject that both sides changed, to different values, is a conflict where it has one value on
// each side; where it has several the changes add up. So is a subject that one side took out whole
// and the other changed. `choose` decides a conflict, or leaves it (nothing); may be empty.
//
// Blank nodes are compared by what is said of them, so their labels do not matter; those that lead
// back to themselves are compared by label. Named graphs are not told apart.
MergeResult MergeThreeWays(
    const Document& base, const Document& ours, const Document& theirs,
    const std::function<std::optional<Side>(const MergeConflict&)>& choose = {});

}  // namespace lares::rdf
