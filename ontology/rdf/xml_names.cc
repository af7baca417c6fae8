#include "ontology/rdf/xml_names.h"

#include <array>
#include <cstdint>

namespace lares::rdf {
namespace {

struct Range {
  std::uint32_t first, last;
};

// XML 1.0 (fifth edition), productions 4 and 4a, without ':'.
constexpr std::array<Range, 15> kNameStart = {{{'A', 'Z'},
                                               {'_', '_'},
                                               {'a', 'z'},
                                               {0xC0, 0xD6},
                                               {0xD8, 0xF6},
                                               {0xF8, 0x2FF},
                                               {0x370, 0x37D},
                                               {0x37F, 0x1FFF},
                                               {0x200C, 0x200D},
                                               {0x2070, 0x218F},
                                               {0x2C00, 0x2FEF},
                                               {0x3001, 0xD7FF},
                                               {0xF900, 0xFDCF},
                                               {0xFDF0, 0xFFFD},
                                               {0x10000, 0xEFFFF}}};
constexpr std::array<Range, 6> kNameMore = {
    {{'-', '-'}, {'.', '.'}, {'0', '9'}, {0xB7, 0xB7}, {0x300, 0x36F}, {0x203F, 0x2040}}};

template <typename Ranges>
bool IsIn(const Ranges& ranges, std::uint32_t code) {
  for (const Range& range : ranges) {
    if (code >= range.first && code <= range.last) return true;
  }
  return false;
}

// The character at `at` of well-formed UTF-8; `at` moves past it.
std::uint32_t NextCode(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t lead = byte(at);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t code = length == 1 ? lead : lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length && at + i < text.size(); ++i) {
    code = (code << 6) | (byte(at + i) & 0x3F);
  }
  at += length;
  return code;
}

}  // namespace

std::size_t XmlNameStart(std::string_view iri) {
  std::size_t start = iri.size();
  bool is_inside = false;
  for (std::size_t at = 0; at < iri.size();) {
    const std::size_t begin = at;
    const std::uint32_t code = NextCode(iri, at);
    const bool can_start = IsIn(kNameStart, code);
    if (!is_inside && can_start) {
      start = begin;
      is_inside = true;
    } else if (is_inside && !can_start && !IsIn(kNameMore, code)) {
      start = iri.size();
      is_inside = false;
    }
  }
  return start;
}

bool IsAsciiXmlName(std::string_view name) {
  for (const char c : name) {
    if (static_cast<unsigned char>(c) >= 0x80) return false;
  }
  return !name.empty() && XmlNameStart(name) == 0;
}

bool IsXmlName(std::string_view text, const XmlNameForm& form) {
  for (std::size_t at = 0; at < text.size();) {
    const bool is_first = at == 0;
    const std::uint32_t code = NextCode(text, at);
    if (code == ':' && form.allows_colon) continue;
    if (IsIn(kNameStart, code)) continue;
    if ((is_first && !form.is_token) || !IsIn(kNameMore, code)) return false;
  }
  return !text.empty();
}

bool IsXmlText(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t code = NextCode(text, at);
    if (code < 0x20 && code != '\t' && code != '\n' && code != '\r') return false;
    if (code == 0xFFFE || code == 0xFFFF) return false;
  }
  return true;
}

}  // namespace lares::rdf
