// Small worlds to ask.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/reader.h"
#include "reasoner/sparql/query.h"

namespace lares::sparql::testing {

// A view of Turtle (http://example.org/ is the empty prefix and the base), asserted by one graph.
struct World {
  explicit World(std::string_view turtle);
  Dataset dataset() const { return {view, {}}; }

  std::shared_ptr<rdf::Dictionary> dictionary = std::make_shared<rdf::Dictionary>();
  rdf::View view;
};

// Each row of the answer as "a=… b=…" with N-Triples terms (IRIs of http://example.org/ as ":x",
// numbers bare), in order; of ASK "yes" or "no".
std::vector<std::string> Rows(const World& world, std::string_view query,
                              const Limits& limits = {});

}  // namespace lares::sparql::testing
