#include "base/xml_text.h"

namespace lares {

std::string EscapedXml(std::string_view text, XmlUse use) {
  const bool is_attribute = use == XmlUse::kAttribute;
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += is_attribute ? "&quot;" : "\"";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      case '\n':
        escaped += is_attribute ? "&#10;" : "\n";
        break;
      case '\t':
        escaped += is_attribute ? "&#9;" : "\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          escaped += "\xEF\xBF\xBD";
        } else {
          escaped += c;
        }
    }
  }
  return escaped;
}

}  // namespace lares
