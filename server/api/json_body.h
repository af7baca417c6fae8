// What requests say in JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lares::api {

// The object that `body` is, with no members but `known`. Throws "bad-request" for what is no JSON,
// kInvalid naming what is wrong with the rest.
nlohmann::json ReadJsonObject(const std::string& body, const std::vector<std::string>& known);

}  // namespace lares::api
