// What a check of an ontology document finds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lares::profile {

enum class Kind {
  kProfile,        // beyond OWL 2 RL: some of what it says will not be concluded
  kStructure,      // no OWL: a list, restriction or axiom that is malformed
  kUndeclared,     // a term in use that nothing declares
  kUnsatisfiable,  // a class that can have no member
  kContradiction,  // with itself or the catalogue
  kRemark,         // worth knowing, and no fault
};

// "profile", "structure", …: stable.
std::string_view ToString(Kind kind);

// One fault, told once however often it is there.
struct Finding {
  Kind kind = Kind::kRemark;
  std::string message;             // what is wrong and why it matters
  std::size_t count = 1;           // places in all
  std::vector<Place> places;       // the first few, in order; at least one
  std::vector<std::string> names;  // what stands there: the classes, properties …, the first few
};

struct Report {
  bool is_owl2_rl = true;         // no kProfile and no kStructure
  bool is_clean = true;           // nothing but remarks
  std::vector<Finding> findings;  // remarks last, otherwise in order of place
};

}  // namespace lares::profile
