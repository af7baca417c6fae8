// Numbers in foreign text.
#pragma once

#include <optional>
#include <string_view>

namespace lares {

// Parses all of `text`, whatever the locale: C++ floating-point notation with an optional '+', and
// "inf", "nan" in any case (also as XML Schema's INF and NaN). What is too large becomes an
// infinity, what is too small a zero. Nothing when it is not a number.
std::optional<double> ToNumber(std::string_view text);

}  // namespace lares
