// What a file looks like from its first bytes.
#pragma once

#include <string>
#include <string_view>

namespace lares::environment {

// "a PNG image", "a gzip archive", …; empty when nothing is recognised. 512 bytes are enough.
std::string_view LooksLike(std::string_view first_bytes);

// "not an OctoMap file: it looks like a PNG image", or without the second half.
std::string NotA(std::string_view expected, std::string_view first_bytes);

}  // namespace lares::environment
