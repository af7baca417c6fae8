#include "base/text.h"
#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/parser.h"

namespace lares::sparql {

using rdf::Term;

bool Parser::StartsTerm() const {
  const Token& token = tokens_.Peek();
  switch (token.kind) {
    case Token::Kind::kIri:
    case Token::Kind::kName:
    case Token::Kind::kBlank:
    case Token::Kind::kVariable:
    case Token::Kind::kInteger:
    case Token::Kind::kDecimal:
    case Token::Kind::kDouble:
    case Token::Kind::kString:
      return true;
    case Token::Kind::kWord:
      return token.IsWord("TRUE") || token.IsWord("FALSE");
    default:
      return token.Is("+") || token.Is("-") || token.Is("()") || token.Is("[]");
  }
}

Parser::Node Parser::AddTerm(Term term) {
  const std::string key = rdf::ToNTriples(term.view());
  const auto [entry, is_new] =
      term_index_.emplace(key, static_cast<std::uint32_t>(query_.terms.size()));
  if (is_new) query_.terms.push_back(std::move(term));
  return {Node::Kind::kTerm, entry->second};
}

Parser::Node Parser::Rdf(std::string_view local) {
  return AddIri(std::string(rdf::kRdf) + std::string(local));
}

// An IRI, literal, blank node or variable.
Parser::Node Parser::ParseTermOrVariable(bool allow_variable) {
  const Token& token = tokens_.Peek();
  switch (token.kind) {
    case Token::Kind::kVariable:
      if (!allow_variable) break;
      return Variable(ParseVariable());
    case Token::Kind::kIri:
    case Token::Kind::kName:
      return AddIri(ParseIri());
    case Token::Kind::kBlank:
      if (!allow_variable) break;
      return ParseBlank();
    default:
      if (token.Is("()")) {
        tokens_.Take();
        return Rdf("nil");
      }
      if (token.Is("[]") && allow_variable) return ParseBlank();
      return ParseLiteral();
  }
  FailHere("a term");
}

Parser::Node Parser::ParseNumber(std::string_view sign) {
  const Token token = tokens_.Take();
  const std::string_view type = token.kind == Token::Kind::kInteger   ? "integer"
                                : token.kind == Token::Kind::kDecimal ? "decimal"
                                                                      : "double";
  return AddTerm(Term::Literal(std::string(sign) + std::string(token.text),
                               std::string(rdf::kXsd) + std::string(type)));
}

Parser::Node Parser::ParseLiteral() {
  const Token token = tokens_.Peek();
  if (token.IsWord("TRUE") || token.IsWord("FALSE")) {
    tokens_.Take();
    return AddTerm(Term::Literal(ToLower(token.text), std::string(rdf::kXsd) + "boolean"));
  }
  if (token.Is("+") || token.Is("-")) {
    tokens_.Take();
    const Token& number = tokens_.Peek();
    const bool is_number = number.kind == Token::Kind::kInteger ||
                           number.kind == Token::Kind::kDecimal ||
                           number.kind == Token::Kind::kDouble;
    if (!is_number || number.begin != token.end) FailHere("a number");
    return ParseNumber(token.text);
  }
  if (token.kind == Token::Kind::kInteger || token.kind == Token::Kind::kDecimal ||
      token.kind == Token::Kind::kDouble) {
    return ParseNumber("");
  }
  if (token.kind != Token::Kind::kString) FailHere("a term");
  tokens_.Take();
  if (tokens_.Peek().kind == Token::Kind::kLanguage) {
    return AddTerm(Term::Literal(token.value, {}, ToLower(tokens_.Take().text)));
  }
  if (!Accept("^^")) return AddTerm(Term::Literal(token.value));
  std::string datatype = ParseIri();
  if (datatype == std::string(rdf::kXsd) + "string") datatype.clear();
  return AddTerm(Term::Literal(token.value, datatype));
}

std::string Parser::ParseIri() {
  const Token token = tokens_.Peek();
  if (token.kind == Token::Kind::kIri) {
    tokens_.Take();
    return ResolveReference(token);
  }
  if (token.kind != Token::Kind::kName) FailHere("an IRI");
  tokens_.Take();
  return ResolveName(token);
}

std::string Parser::ResolveReference(const Token& token) {
  if (rdf::IsAbsoluteIri(token.text)) return std::string(token.text);
  if (query_.base_iri.empty()) {
    tokens_.Fail("the relative IRI <" + std::string(token.text) + "> needs a BASE", token.begin);
  }
  std::string iri;
  rdf::ResolveIri(token.text, query_.base_iri, iri);
  return iri;
}

std::string Parser::ResolveName(const Token& token) {
  const std::size_t colon = token.text.find(':');
  const std::string prefix(token.text.substr(0, colon));
  std::string iri;
  if (const auto known = query_.prefixes.find(prefix); known != query_.prefixes.end()) {
    iri = known->second;
  } else if (const auto given = options_.prefixes.find(prefix); given != options_.prefixes.end()) {
    iri = given->second;
  } else {
    tokens_.Fail("the prefix '" + prefix + ":' is not declared", token.begin);
  }
  const std::string_view local = token.text.substr(colon + 1);
  for (std::size_t i = 0; i < local.size(); ++i) {
    if (local[i] != '\\')
      iri += local[i];
    else if (++i < local.size())
      iri += local[i];
  }
  return iri;
}

Parser::Slot Parser::ParseVariable() {
  if (tokens_.Peek().kind != Token::Kind::kVariable) FailHere("a variable");
  return SlotOf(tokens_.Take().text);
}

Parser::Slot Parser::SlotOf(std::string_view name) {
  auto& slots = scopes_.back().slots;
  if (const auto known = slots.find(name); known != slots.end()) return known->second;
  const auto slot = static_cast<Slot>(query_.columns.size());
  if (slot >= 2 * options_.max_steps + 100) {
    throw Error(Code::kTooLarge, "the query has too many variables",
                tokens_.PlaceOf(tokens_.Peek().begin));
  }
  const std::string kept(name);  // `name` may be a column's own, which moves now
  query_.columns.push_back({kept, false});
  slots.emplace(kept, slot);
  return slot;
}

Parser::Slot Parser::HiddenSlot(std::string name) {
  const auto slot = static_cast<Slot>(query_.columns.size());
  query_.columns.push_back({std::move(name), true});
  return slot;
}

}  // namespace lares::sparql
