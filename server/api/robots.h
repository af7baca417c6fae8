// Robots over HTTP: what their files share.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "robots/urdf/finding.h"
#include "robots/urdf/import.h"
#include "server/api/context.h"
#include "server/api/json.h"

namespace lares::api {

inline constexpr const char* kUrdfType = "application/urdf+xml";

// The URDF that a stored robot was put from.
struct StoredUrdf {
  store::DocumentInfo document;  // its SRDL
  store::Blob blob;
  std::string file_name;
};
// Of the newest version by any of the robot's names (`version` 0), of an older one by its id.
// Throws kNotFound, too where the robot was put as SRDL.
StoredUrdf FindUrdf(Context& context, const std::string& robot, int version = 0);

// What was concluded, each conclusion with its reason.
Json ToJson(const urdf::Imported& imported, const std::vector<recipes::Resource>& stated);
Json ToJson(const std::vector<urdf::Finding>& findings);

// Capabilities, tree, doctor.
void AddRobotQuestionRoutes(http::Router& router, Context& context);

}  // namespace lares::api
