// `lares plan … --package DIR`: a plan and all that it needs on board, in one folder.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "server/cli/command.h"

namespace lares::cli {

using Json = nlohmann::ordered_json;

// Throws kConflict when `out` is there and not empty. Nothing is there afterwards, as with every
// other fault.
void CheckPackageFolder(const std::string& out);

// `answer` is a plan as the server's JSON. Writes plan.json, plan.xml, package.json, models/,
// grid/ and layers/ into `out`, which appears whole or not at all. Throws kConflict as above, kIo
// for a file that arrived damaged, RemoteError.
void SavePackage(Remote& remote, const std::string& answer, const std::string& out,
                 const Options& options);

}  // namespace lares::cli
