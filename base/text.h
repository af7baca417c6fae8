// Small text helpers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lares {

std::vector<std::string> Split(std::string_view text, char separator);
std::string Join(const std::vector<std::string>& parts, std::string_view separator);
std::string_view Trim(std::string_view text);
std::string ToLower(std::string_view text);  // ASCII only

// True when the bytes are well-formed UTF-8 (no surrogates, no overlong forms).
bool IsUtf8(std::string_view bytes);

// The candidates that a person may have meant by `name`: edit distance at most a third of its
// length, nearest first, at most `limit`.
std::vector<std::string> SimilarNames(std::string_view name,
                                      const std::vector<std::string>& candidates,
                                      std::size_t limit = 3);

std::size_t CodePoints(std::string_view text);  // of UTF-8
// At most `most` code points of UTF-8 text, the last an ellipsis where something was cut off.
std::string Shortened(std::string_view text, std::size_t most);

// A name for files and URLs: 1–128 of [A-Za-z0-9._-], first not '.' or '-'.
bool IsIdentifier(std::string_view text);

// Everything after the last '#' or '/' of an IRI; the whole of it when there is none.
std::string_view LocalName(std::string_view iri);

}  // namespace lares
