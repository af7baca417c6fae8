#include "ontology/rdf/turtle_prescan.h"

#include <algorithm>

#include "ontology/rdf/position.h"

namespace lares::rdf {
namespace {

// Past the string that begins at `at`; the end of the text when it does not end.
std::size_t SkipString(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool is_long = text.substr(at, 3) == triple;
  for (at += is_long ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\') {
      ++at;
    } else if (is_long) {
      if (text.substr(at, 3) == triple) return at + 3;
    } else if (text[at] == quote || text[at] == '\n') {
      return at + 1;
    }
  }
  return text.size();
}

// Past the IRI that begins at `at`; just past '<' when no IRI does.
std::size_t SkipIri(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_of(std::string_view("> \t\r\n<\"{}\0", 9), at + 1);
  return end != std::string_view::npos && text[end] == '>' ? end + 1 : at + 1;
}

std::size_t SkipComment(std::string_view text, std::size_t at) {
  return std::min(text.find_first_of(std::string_view("\r\n\0", 3), at), text.size());
}

}  // namespace

void CheckTurtleText(std::string_view text, const ReadOptions& options) {
  int depth = 0;
  std::size_t at = 0;
  constexpr std::string_view kOfInterest("[](){}<\"'#\\\0", 11);
  while ((at = text.find_first_of(kOfInterest, at)) != std::string_view::npos) {
    switch (text[at]) {
      case '\0':
        throw Error(Code::kInvalid, "a NUL byte: this is not text",
                    PlaceAt(text, at, options.source));
      case '"':
      case '\'':
        at = SkipString(text, at);
        break;
      case '<':
        at = SkipIri(text, at);
        break;
      case '#':
        at = SkipComment(text, at);
        break;
      case '\\':
        at += 2;
        break;  // an escape in a local name
      case '[':
      case '(':
      case '{':
        if (++depth > options.max_depth) {
          throw Error(Code::kTooLarge,
                      "brackets nest deeper than " + std::to_string(options.max_depth),
                      PlaceAt(text, at, options.source));
        }
        ++at;
        break;
      default:
        depth = std::max(0, depth - 1);
        ++at;
    }
    if (at >= text.size()) return;
  }
}

}  // namespace lares::rdf
