// Konclude (Steigmiller, Liebig & Glimm 2014), a reasoner of OWL 2 DL, as a program beside ours.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace lares::bench {

// "subject predicate object", of IRIs alone.
using Facts = std::set<std::string>;

struct Conclusions {
  Facts facts;
  bool is_consistent = true;
};

// What follows from a file of OWL/XML; its folder takes what Konclude writes. It runs with two
// workers, for with one it hangs, and what it answers now and then lacks something. Throws
// kInternal when it fails.

// The types of individuals, and what the object properties `properties` link.
Conclusions IndividualsByKonclude(const std::filesystem::path& file,
                                  const std::vector<std::string>& properties);
// c rdfs:subClassOf d, for all that there is between named classes.
Conclusions ClassesByKonclude(const std::filesystem::path& file);

}  // namespace lares::bench
