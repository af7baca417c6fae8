// As much of JSON Schema 2020-12 as the project's schemas use.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lares::testing {

// One line for each violation: "/states/0/id: does not match …". A keyword that is not known here
// is a violation, too, so that nothing passes unchecked.
std::vector<std::string> ValidateJson(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace lares::testing
