// Where a document says what a sentence about it names.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace lares::server {

// Where `bytes` say the first of the names in quotes or angle brackets of `sentence` that they say
// at all, best where they begin to describe it: the place of a fault that was found only after
// reading. Line and column 0 without any.
Place PlaceOf(const std::string& sentence, std::string_view bytes, const std::string& source);

}  // namespace lares::server
