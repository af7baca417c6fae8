#include "ontology/rdf/xml_declarations.h"

#include <vector>

#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/xml_tokens.h"

namespace lares::rdf {
namespace {

using Kind = XmlToken::Kind;
using Attribute = XmlToken::Attribute;
constexpr std::size_t kNowhere = std::string_view::npos;
constexpr int kDeepestEntity = 16;
constexpr std::size_t kLongestValue = 1 << 16;

}  // namespace

std::optional<std::string> XmlDeclarations::Expand(std::string_view text, int depth) const {
  if (depth > kDeepestEntity) return std::nullopt;
  std::string expanded;
  for (;;) {
    const std::size_t at = text.find('&');
    expanded += text.substr(0, at);
    if (expanded.size() > kLongestValue) return std::nullopt;
    if (at == kNowhere) return expanded;
    const std::size_t end = text.find(';', at);
    if (end == kNowhere) return std::nullopt;
    const auto entity = entities.find(text.substr(at + 1, end - at - 1));
    if (entity == entities.end()) return std::nullopt;
    const auto value = Expand(entity->second, depth + 1);
    if (!value) return std::nullopt;
    expanded += *value;
    text.remove_prefix(end + 1);
  }
}

XmlDeclarations CollectDeclarations(std::string_view text) {
  XmlDeclarations found;
  std::vector<Attribute> bindings;
  XmlTokens tokens(text);
  for (XmlToken token = tokens.Next(); token.kind != Kind::kEnd; token = tokens.Next()) {
    if (token.kind == Kind::kEntity) found.entities.emplace(token.name, token.value);
    for (const Attribute& attribute : token.attributes) {
      if (attribute.name.starts_with("xmlns:")) bindings.push_back(attribute);
    }
  }
  for (const Attribute& binding : bindings) {
    const std::string prefix(binding.name.substr(6));
    const auto space = found.Expand(binding.value);
    if (!space) continue;
    const auto [row, is_new] = found.prefixes.emplace(prefix, space);
    if (!is_new && row->second != space) row->second.reset();
  }
  found.prefixes.emplace("rdf", std::string(kRdf));
  found.prefixes.emplace("rdfs", std::string(kRdfs));
  found.prefixes.emplace("owl", std::string(kOwl));
  found.prefixes.emplace("xsd", std::string(kXsd));
  return found;
}

}  // namespace lares::rdf
