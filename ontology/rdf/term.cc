#include "ontology/rdf/term.h"

#include <cstdio>

namespace lares::rdf {
namespace {

void AppendEscaped(std::string_view text, std::string& out) {
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
          char code[8];
          std::snprintf(code, sizeof code, "\\u%04X", static_cast<unsigned>(c));
          out += code;
        } else {
          out += c;
        }
    }
  }
}

}  // namespace

std::string ToNTriples(const TermView& term) {
  std::string text;
  switch (term.kind) {
    case TermKind::kIri:
      text.append("<").append(term.value).append(">");
      break;
    case TermKind::kBlank:
      text.append("_:").append(term.value);
      break;
    case TermKind::kLiteral:
      text += '"';
      AppendEscaped(term.value, text);
      text += '"';
      if (!term.language.empty()) {
        text.append("@").append(term.language);
      } else if (!term.datatype.empty()) {
        text.append("^^<").append(term.datatype).append(">");
      }
      break;
  }
  return text;
}

}  // namespace lares::rdf
