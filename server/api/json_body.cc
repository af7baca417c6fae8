#include "server/api/json_body.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/http/problem.h"

namespace lares::api {

nlohmann::json ReadJsonObject(const std::string& body, const std::vector<std::string>& known) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(body);
  } catch (const nlohmann::json::parse_error& error) {
    throw http::ProblemError("bad-request", std::string("the body is no JSON: ") + error.what());
  }
  if (!json.is_object()) throw Error(Code::kInvalid, "the body must be a JSON object");
  for (const auto& [name, value] : json.items()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw Error(Code::kInvalid, "'" + name + "' is not known here")
          .WithHint("the members are " + Join(known, ", "));
    }
  }
  return json;
}

}  // namespace lares::api
