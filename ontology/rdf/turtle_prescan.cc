#include "ontology/rdf/turtle_prescan.h"

#include <algorithm>

#include "ontology/rdf/byte_set.h"
#include "ontology/rdf/position.h"

namespace lares::rdf {
namespace {

// Past the string that begins at `at`; the end of the text when it does not end.
std::size_t SkipString(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool is_long = text.substr(at, 3) == triple;
  static constexpr ByteSet kStops("\\\"'\n");
  for (at = kStops.Find(text, at + (is_long ? 3 : 1)); at < text.size();
       at = kStops.Find(text, at + 1)) {
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
  static constexpr ByteSet kEnds(std::string_view("> \t\r\n<\"{}\0", 10));
  const std::size_t end = kEnds.Find(text, at + 1);
  return end < text.size() && text[end] == '>' ? end + 1 : at + 1;
}

std::size_t SkipComment(std::string_view text, std::size_t at) {
  static constexpr ByteSet kEnds(std::string_view("\r\n\0", 3));
  return kEnds.Find(text, at);
}

// True where "_:" at `at` begins a label and does not end the prefix of a name ("a_:b").
bool IsLabelStart(std::string_view text, std::size_t at) {
  while (at > 0 && text[at - 1] == '.') --at;
  if (at == 0) return true;
  const char c = text[at - 1];
  const bool is_name_byte = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                            (c >= '0' && c <= '9') || c == '_' || c == '-' || c == ':' ||
                            c == '%' || static_cast<unsigned char>(c) >= 0x80;
  return !is_name_byte;
}

}  // namespace

void CheckTurtleText(std::string_view text, Format format, const ReadOptions& options) {
  int depth = 0;
  static constexpr ByteSet kOfInterest(std::string_view("[](){}<\"'#\\\0", 12));
  for (std::size_t at = kOfInterest.Find(text, 0); at < text.size();
       at = kOfInterest.Find(text, at)) {
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
        if (text[at] == '{' && format == Format::kTurtle) {
          throw Error(Code::kInvalid, "'{' begins a graph: Turtle has none, TriG has",
                      PlaceAt(text, at, options.source));
        }
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
  }
}

RelabelledText RelabelBlanks(std::string_view text) {
  RelabelledText result;
  std::size_t done = 0;
  static constexpr ByteSet kOfInterest("<\"'#\\_");
  for (std::size_t at = kOfInterest.Find(text, 0); at < text.size();
       at = kOfInterest.Find(text, at)) {
    switch (text[at]) {
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
        break;
      default:
        if (text.substr(at).starts_with("_:") && IsLabelStart(text, at)) {
          result.text.append(text.substr(done, at + 2 - done)).append("L");
          result.insertions.push_back(result.text.size() - 1);
          done = at + 2;
        }
        ++at;
    }
  }
  result.text.append(text.substr(std::min(done, text.size())));
  return result;
}

std::size_t RelabelledText::OriginalOffset(std::size_t offset) const {
  const auto before = std::lower_bound(insertions.begin(), insertions.end(), offset);
  return offset - static_cast<std::size_t>(before - insertions.begin());
}

}  // namespace lares::rdf
