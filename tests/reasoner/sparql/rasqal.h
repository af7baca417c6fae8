// Rasqal, an implementation of SPARQL by others, as its program roqet.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/reasoner/sparql/w3c_results.h"

namespace lares::sparql::testing {

bool HasRoqet();

// roqet's answer to one query over files, the first kind in the default graph. `folder` is where it
// may write. None when it says that it cannot, crashes or takes more than ten seconds.
std::optional<Expected> AskRasqal(const std::filesystem::path& query, const std::string& base_iri,
                                  const std::vector<std::filesystem::path>& data,
                                  const std::vector<std::filesystem::path>& graphs, Form form,
                                  const std::filesystem::path& folder);

}  // namespace lares::sparql::testing
