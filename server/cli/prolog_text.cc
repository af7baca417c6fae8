#include "server/cli/prolog_text.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kPrefixes{
    {{"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
     {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"},
     {"owl", "http://www.w3.org/2002/07/owl#"},
     {"xsd", "http://www.w3.org/2001/XMLSchema#"},
     {"lares", "https://w3id.org/lares#"}}};

// Control characters never reach the terminal.
std::string Escaped(std::string_view text, char quote) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == quote || c == '\\') {
      escaped += '\\';
      escaped += c;
    } else if (c == '\n') {
      escaped += "\\n";
    } else if (byte < 0x20 || byte == 0x7f) {
      escaped += std::string("\\x") + kHex[byte >> 4] + kHex[byte & 15] + "\\";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

bool IsPlainAtom(std::string_view text) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' &&
         std::all_of(text.begin(), text.end(), is_word);
}

std::string AtomText(std::string_view text) {
  return IsPlainAtom(text) ? std::string(text) : "'" + Escaped(text, '\'') + "'";
}

std::string IriText(std::string_view iri) {
  for (const auto& [prefix, space] : kPrefixes) {
    if (iri.starts_with(space) && iri.size() > space.size()) {
      return std::string(prefix) + ":" + AtomText(iri.substr(space.size()));
    }
  }
  return AtomText(iri);
}

std::string Joined(const Json& values) {
  std::string text;
  for (const Json& value : values) text += (text.empty() ? "" : ", ") + PrologText(value);
  return text;
}

Json Member(const Json& value, const char* name) {
  const auto found = value.find(name);
  return found == value.end() ? Json() : *found;
}

std::string LiteralText(const Json& value) {
  std::string text = "\"" + Escaped(TextOf(value, "value"), '"') + "\"";
  if (value.contains("xml:lang")) return text + "@" + Escaped(TextOf(value, "xml:lang"), '"');
  if (value.contains("datatype")) return text + "^^" + IriText(TextOf(value, "datatype"));
  return text;
}

std::string DictText(const Json& values) {
  std::string text;
  for (const auto& [key, value] : values.items()) {
    text += (text.empty() ? "" : ", ") + AtomText(key) + ": " + PrologText(value);
  }
  return "_{" + text + "}";
}

std::string TypedText(const Json& value) {
  const std::string type = TextOf(value, "type");
  const std::string text = TextOf(value, "value");
  if (type == "uri") return IriText(text);
  if (type == "bnode") return "'_:" + Escaped(text, '\'') + "'";
  if (type == "literal") return LiteralText(value);
  if (type == "atom") return AtomText(text);
  if (type == "variable") return Escaped(TextOf(value, "name"), '\'');
  if (type == "compound") {
    return AtomText(TextOf(value, "name")) + "(" + Joined(Member(value, "arguments")) + ")";
  }
  if (type == "partial-list") {
    return "[" + Joined(Member(value, "elements")) + "|" + PrologText(Member(value, "rest")) + "]";
  }
  if (type == "dict") return DictText(Member(value, "values"));
  if (type == "cyclic") return "<cyclic>";
  if (type == "cut") return "<…>";
  return Escaped(text, '\'');
}

}  // namespace

std::string PrologText(const Json& value) {
  if (value.is_array()) return "[" + Joined(value) + "]";
  if (value.is_string()) return "\"" + Escaped(value.get<std::string>(), '"') + "\"";
  if (value.is_object()) return TypedText(value);
  return value.dump();
}

std::string AnswerText(const Json& answer) {
  std::string text;
  for (const auto& [name, value] : answer.items()) {
    if (TextOf(value.is_object() ? value : Json::object(), "type") == "variable") continue;
    text += (text.empty() ? "" : ", ") + name + " = " + PrologText(value);
  }
  return text.empty() ? "yes" : text;
}

}  // namespace lares::cli
