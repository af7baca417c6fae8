// POSIX ustar archives, written piece by piece.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/time.h"

namespace lares::api {

// The 512 bytes before a file's content. Sizes beyond 8 GiB are written in GNU's base-256 form.
// Throws kInvalid for a name of more than 100 bytes.
std::string TarHeader(std::string_view name, std::uint64_t size, Time modified);
// The zeros after a content of `size` bytes.
std::string TarPadding(std::uint64_t size);
// The two empty blocks at the end.
std::string TarEnd();
// Header, content and padding together.
std::uint64_t TarEntrySize(std::uint64_t size);

}  // namespace lares::api
