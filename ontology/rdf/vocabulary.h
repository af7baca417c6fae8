// The IRIs that C++ code names. Everything else is named in *.ttl and *.pl.
#pragma once

#include <string_view>

namespace lares::rdf {

inline constexpr std::string_view kRdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline constexpr std::string_view kRdfs = "http://www.w3.org/2000/01/rdf-schema#";
inline constexpr std::string_view kOwl = "http://www.w3.org/2002/07/owl#";
inline constexpr std::string_view kXsd = "http://www.w3.org/2001/XMLSchema#";
// Lares' own vocabulary: one namespace for all modules.
inline constexpr std::string_view kLares = "https://w3id.org/lares#";

}  // namespace lares::rdf
