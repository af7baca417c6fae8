#include "ontology/rdf/term_checks.h"

#include <algorithm>

#include "base/text.h"
#include "ontology/rdf/byte_set.h"

namespace lares::rdf {
namespace {

bool IsAlpha(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsAlnum(char c) { return IsAlpha(c) || (c >= '0' && c <= '9'); }

constexpr ByteSet kForbiddenInIri(
    std::string_view("\x00\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0A\x0B\x0C\x0D\x0E\x0F"
                     "\x10\x11\x12\x13\x14\x15\x16\x17\x18\x19\x1A\x1B\x1C\x1D\x1E\x1F"
                     " <>\"{}|\\^`",
                     42));

bool IsWellFormedUtf8(std::string_view text) { return IsAscii(text) || IsUtf8(text); }

bool HasScheme(std::string_view iri) {
  if (iri.empty() || !IsAlpha(iri[0])) return false;
  for (const char c : iri) {
    if (c == ':') return true;
    if (!IsAlnum(c) && c != '+' && c != '-' && c != '.') return false;
  }
  return false;
}

// BCP 47's shape: letters, then subtags of 1–8 letters and digits.
bool IsLanguageTag(std::string_view tag) {
  bool is_first = true;
  for (const std::string& subtag : Split(tag, '-')) {
    if (subtag.empty() || subtag.size() > 8) return false;
    const bool fits = is_first ? std::all_of(subtag.begin(), subtag.end(), IsAlpha)
                               : std::all_of(subtag.begin(), subtag.end(), IsAlnum);
    if (!fits) return false;
    is_first = false;
  }
  return true;
}

std::optional<std::string> FaultOfIri(std::string_view iri) {
  const std::size_t at = kForbiddenInIri.Find(iri, 0);
  if (at < iri.size()) {
    const char bad = iri[at];
    const std::string name = bad == ' ' ? "a space"
                             : static_cast<unsigned char>(bad) < 0x20
                                 ? "a control character"
                                 : "the character '" + std::string(1, bad) + "'";
    return "the IRI " + Quoted(iri) + " has " + name + " in it";
  }
  if (!HasScheme(iri)) return "the IRI " + Quoted(iri) + " is relative, and no base IRI is known";
  return std::nullopt;
}

}  // namespace

bool IsAbsoluteIri(std::string_view iri) {
  return HasScheme(iri) && kForbiddenInIri.Find(iri, 0) == iri.size();
}

std::optional<std::string> FaultOf(const TermView& term) {
  if (term.kind == TermKind::kBlank) return std::nullopt;
  if (!IsWellFormedUtf8(term.value)) return "the term " + Quoted(term.value) + " is not UTF-8";
  if (term.kind == TermKind::kIri) return FaultOfIri(term.value);
  if (!term.datatype.empty()) {
    if (!IsWellFormedUtf8(term.datatype))
      return "the datatype " + Quoted(term.datatype) + " is not UTF-8";
    if (auto fault = FaultOfIri(term.datatype)) return fault;
  }
  if (!term.language.empty() && !IsLanguageTag(term.language)) {
    return Quoted(term.language) + " is not a language tag";
  }
  return std::nullopt;
}

bool IsBlankLabel(std::string_view label) {
  if (label.empty() || !(IsAlnum(label[0]) || label[0] == '_') || label.back() == '.') return false;
  return std::all_of(label.begin(), label.end(),
                     [](char c) { return IsAlnum(c) || c == '_' || c == '-' || c == '.'; });
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  const bool is_utf8 = IsUtf8(text);
  std::string quoted = "'";
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    quoted += byte < 0x20 || byte == 0x7F || (byte >= 0x80 && !is_utf8) ? '?' : c;
  }
  if (text.size() > kLongest) {
    while (!IsUtf8(quoted) && quoted.size() > 1) quoted.pop_back();
    quoted += "…";
  }
  return quoted + "'";
}

}  // namespace lares::rdf
