// The lines of N-Triples and N-Quads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "ontology/rdf/byte_set.h"

namespace lares::rdf {

inline constexpr ByteSet kLineEnds("\r\n");

// Calls `visit(begin, line)` for each line that has a statement or part of one.
template <typename Visit>
void ForEachLine(std::string_view text, Visit&& visit) {
  const bool has_returns = text.find('\r') != std::string_view::npos;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end =
        has_returns ? kLineEnds.Find(text, begin) : std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && line[first] != '#') visit(begin, line);
    begin = end + 1;
  }
}

inline std::size_t CountLines(std::string_view text) {
  std::size_t lines = 0;
  ForEachLine(text, [&](std::size_t, std::string_view) { ++lines; });
  return lines;
}

// Where `text` has something else than white space and comments; its size when it has nothing.
inline std::size_t SkipBlank(std::string_view text) {
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos) {
    if (text[at] != '#') return at;
    at = kLineEnds.Find(text, at);
  }
  return text.size();
}

}  // namespace lares::rdf
