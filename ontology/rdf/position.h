// Places in a text, for error messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"

namespace lares::rdf {

// Line and column of byte `offset` of `text`; columns count UTF-8 characters, and a byte order mark
// counts nothing.
Place PlaceAt(std::string_view text, std::size_t offset, const std::string& source);

// The reverse, for `column` in characters; the end of the line when it has fewer.
std::size_t OffsetOf(std::string_view text, int line, int column);

// Where line `line` begins; the end of the text when there is no such line.
std::size_t LineStart(std::string_view text, int line);

// `error` with `place`, unless it names one already.
Error WithPlace(const Error& error, Place place);

}  // namespace lares::rdf
