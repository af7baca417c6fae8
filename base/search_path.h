// Where the project's own run-time files are: ontology modules, tables, library recipes, robots.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lares {

// Folders that may hold `ontology/`, `recipes/`, `robots/`, first wins: $LARES_SHARE,
// <folder of the binary>/../share/lares, the source tree that the binary was built from.
std::vector<std::filesystem::path> SharePath();

// `relative` in the first folder that has it. Throws kNotFound naming the folders tried.
std::filesystem::path FindShared(const std::filesystem::path& relative);

// The files with extension `extension` (".ttl") directly in share folder `relative`, by name.
std::vector<std::filesystem::path> ListShared(const std::filesystem::path& relative,
                                              const std::string& extension);

}  // namespace lares
