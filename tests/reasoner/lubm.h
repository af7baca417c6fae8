// LUBM(1), closed: a university's worth of data for tests and measurements.
#pragma once

#include <filesystem>
#include <memory>

#include "ontology/triples/view.h"

namespace lares::testing {

// Two layers: the ontology ("univ-bench.ttl") and the data ("lubm").
rdf::View ReadLubm(const std::filesystem::path& folder,
                   const std::shared_ptr<rdf::Dictionary>& dictionary);

}  // namespace lares::testing
