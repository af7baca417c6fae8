// The Lehigh University Benchmark's files: a university's worth of data for tests and measurements.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::testing {

// The data of LUBM(1) as N-Triples. Throws kIo.
std::string LubmData(const std::filesystem::path& folder);

// Closed, in two layers: the ontology ("univ-bench.ttl") and the data ("lubm").
rdf::View ReadLubm(const std::filesystem::path& folder,
                   const std::shared_ptr<rdf::Dictionary>& dictionary);

// The text of query `number` of 1 to 14, and the rows of its reference answer as sorted lines.
std::string LubmQuery(const std::filesystem::path& folder, int number);
std::vector<std::string> LubmAnswers(const std::filesystem::path& folder, int number);

}  // namespace lares::testing
