// Everything that can be said about an ontology document before it is put.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include "ontology/rdf/aliases.h"
#include "ontology/rdf/document.h"
#include "ontology/triples/view.h"
#include "reasoner/profile/finding.h"

namespace lares::profile {

struct Input {
  const rdf::Document& document;  // best read with ReadOptions::record_lines
  std::string_view text;          // what it was read from, for places
  std::string source;             // file name in places
  const rdf::AliasTable& aliases;
  const rdf::View& catalogue;  // closed
};

// Why it is not OWL 2 RL, what is malformed or undeclared, which classes can have no member, what
// contradicts. Throws kTooLarge and kTimeout (stop requested).
Report Check(const Input& input, std::stop_token stop = {});

}  // namespace lares::profile
