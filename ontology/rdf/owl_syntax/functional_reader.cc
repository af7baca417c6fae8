#include <array>
#include <string>
#include <unordered_map>

#include "ontology/rdf/byte_set.h"
#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/owl_syntax/axiom_assembler.h"
#include "ontology/rdf/owl_syntax/functional_tokens.h"
#include "ontology/rdf/owl_syntax/owl_readers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

using Token = FunctionalToken;
using TokenKind = Token::Kind;
using NodeKind = OwlNode::Kind;

// Prefixes that need no declaration (Structural Specification, table 2).
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kStandardPrefixes = {
    {{"rdf", kRdf}, {"rdfs", kRdfs}, {"owl", kOwl}, {"xsd", kXsd}}};

class FunctionalReader {
 public:
  FunctionalReader(std::string_view text, const ReadOptions& options)
      : text_(text),
        options_(options),
        tokens_(text),
        builder_(Format::kOwlFunctional, options),
        axioms_(builder_, options, [this](const SourcePoint& point) { return At(point.offset); }) {
    for (const auto& [prefix, space] : kStandardPrefixes) prefixes_.emplace(prefix, space);
  }

  Document Read();

 private:
  void ReadPrefix();
  void ReadOntology();
  void ReadImport();
  void ReadTree();
  void OpenGroup();
  void SkipRule();
  OwlNode ReadLiteral();
  OwlNode ReadLeaf();
  // The IRI of `token`, in the text or in `scratch`.
  std::string_view IriOf(const Token& token, std::string& scratch);
  std::uint32_t Intern(const TermView& term, std::size_t begin);

  void Advance();
  void Expect(TokenKind kind, const std::string& what);
  bool IsIri() const {
    return token_.kind == TokenKind::kFullIri || token_.kind == TokenKind::kShortIri;
  }
  bool IsName(std::string_view name) const {
    return token_.kind == TokenKind::kName && token_.text == name;
  }
  Place At(std::size_t offset) const { return PlaceAt(text_, offset, options_.source); }
  [[noreturn]] void Refuse(const std::string& message, std::size_t begin) const {
    throw Error(Code::kInvalid, message, At(begin));
  }
  [[noreturn]] void RefuseToken(const std::string& wanted) const {
    Refuse("expected " + wanted + ", not " + Describe(token_), token_.begin);
  }

  std::string_view text_;
  const ReadOptions& options_;
  FunctionalTokens tokens_;
  Token token_;
  DocumentBuilder builder_;
  AxiomAssembler axioms_;
  std::unordered_map<std::string, std::string> prefixes_;
  std::string iri_;  // scratch, all three
  std::string prefix_;
  std::string lexical_;
};

Document FunctionalReader::Read() {
  Advance();
  while (IsName("Prefix")) ReadPrefix();
  ReadOntology();
  if (token_.kind != TokenKind::kEnd) RefuseToken("nothing after the ontology");
  return builder_.Finish();
}

void FunctionalReader::Advance() {
  try {
    token_ = tokens_.Next();
  } catch (const Error& error) {
    throw WithPlace(error, At(tokens_.FaultOffset()));
  }
}

void FunctionalReader::Expect(TokenKind kind, const std::string& what) {
  if (token_.kind != kind) RefuseToken(what);
  Advance();
}

void FunctionalReader::ReadPrefix() {
  Advance();
  Expect(TokenKind::kOpen, "'('");
  const Token name = token_;
  Expect(TokenKind::kShortIri, "a prefix such as 'a:'");
  if (name.text.find(':') + 1 != name.text.size()) {
    Refuse("the prefix " + Quoted(name.text) + " does not end with ':'", name.begin);
  }
  Expect(TokenKind::kEquals, "'='");
  const std::string prefix(name.text.substr(0, name.text.size() - 1));
  if (token_.kind != TokenKind::kFullIri) RefuseToken("an IRI in < and >");
  const std::string space(IriOf(token_, iri_));
  if (!IsAbsoluteIri(space)) Refuse("the IRI " + Quoted(space) + " is not absolute", token_.begin);
  Advance();
  Expect(TokenKind::kClose, "')'");
  const auto [row, is_new] = prefixes_.emplace(prefix, space);
  if (!is_new && row->second != space) {
    Refuse("the prefix '" + prefix + ":' means <" + row->second + "> already", name.begin);
  }
  builder_.document().prefixes.emplace(prefix, space);
}

void FunctionalReader::ReadOntology() {
  if (!IsName("Ontology")) RefuseToken("Prefix(…) or Ontology(…)");
  const std::size_t begin = token_.begin;
  Advance();
  Expect(TokenKind::kOpen, "'('");
  if (IsIri()) {
    axioms_.rdf().Ontology(Intern({TermKind::kIri, IriOf(token_, iri_), {}, {}}, token_.begin));
    Advance();
    if (IsIri()) {
      axioms_.rdf().Version(Intern({TermKind::kIri, IriOf(token_, iri_), {}, {}}, token_.begin));
      Advance();
    }
  } else {
    axioms_.rdf().NamelessOntology();
  }
  while (token_.kind == TokenKind::kName) {
    if (token_.text == "Import") {
      ReadImport();
    } else if (token_.text == "DLSafeRule" || token_.text == "DGRule" ||
               token_.text == "DescriptionGraph") {
      SkipRule();
    } else {
      ReadTree();
    }
  }
  if (token_.kind == TokenKind::kEnd) Refuse("the ontology that begins here does not end", begin);
  Expect(TokenKind::kClose, "an axiom or ')'");
}

void FunctionalReader::ReadImport() {
  Advance();
  Expect(TokenKind::kOpen, "'('");
  if (!IsIri()) RefuseToken("an IRI");
  axioms_.rdf().Import(Intern({TermKind::kIri, IriOf(token_, iri_), {}, {}}, token_.begin));
  Advance();
  Expect(TokenKind::kClose, "')'");
}

// Rules are an extension that OWL 2 does not have.
void FunctionalReader::SkipRule() {
  const Token rule = token_;
  Advance();
  if (token_.kind != TokenKind::kOpen) RefuseToken("'('");
  std::size_t depth = 0;
  do {
    if (token_.kind == TokenKind::kOpen) ++depth;
    if (token_.kind == TokenKind::kClose) --depth;
    if (token_.kind == TokenKind::kEnd) {
      Refuse("the " + std::string(rule.text) + " that begins here does not end", rule.begin);
    }
    Advance();
  } while (depth > 0);
  builder_.document().remarks.push_back(
      {Remark::Kind::kWarning, At(rule.begin),
       "a " + std::string(rule.text) + " is no part of OWL 2 and was left out"});
}

void FunctionalReader::ReadTree() {
  do {
    switch (token_.kind) {
      case TokenKind::kName: {
        if (token_.text == "FacetRestriction") {  // OWL/XML's
          Refuse("'FacetRestriction' is no construct of functional syntax", token_.begin);
        }
        axioms_.Open(token_.text, {token_.begin});
        Advance();
        Expect(TokenKind::kOpen, "'('");
        break;
      }
      case TokenKind::kClose:
        axioms_.Close();
        Advance();
        break;
      case TokenKind::kOpen:
        OpenGroup();
        Advance();
        break;
      case TokenKind::kEnd:
        Refuse("the " + std::string(InfoOf(axioms_.top().construct).name) +
                   " that begins here does not end",
               axioms_.top().point.offset);
      case TokenKind::kString:
        axioms_.Add(ReadLiteral());
        break;
      default:
        axioms_.Add(ReadLeaf());
        Advance();
    }
  } while (axioms_.depth() > 0);
}

// The two lists of HasKey.
void FunctionalReader::OpenGroup() {
  const OwlNode& top = axioms_.top();
  const std::size_t before = top.arguments.size();
  if (top.construct != Construct::kHasKey || before < 1 || before > 2) {
    Refuse("'(' without a name before it", token_.begin);
  }
  axioms_.Open(before == 1 ? Construct::kObjectProperties : Construct::kDataProperties,
               {token_.begin});
}

OwlNode FunctionalReader::ReadLeaf() {
  const SourcePoint point{token_.begin};
  switch (token_.kind) {
    case TokenKind::kFullIri:
    case TokenKind::kShortIri:
      return OwlNode::Leaf(NodeKind::kIri,
                           Intern({TermKind::kIri, IriOf(token_, iri_), {}, {}}, point.offset),
                           point);
    case TokenKind::kNode:
      if (!IsNodeLabel(token_.text))
        Refuse(Quoted(token_.text) + " is no node's label", point.offset);
      return OwlNode::Leaf(NodeKind::kBlank, axioms_.rdf().Blank(token_.text), point);
    case TokenKind::kNumber:
      return OwlNode::Leaf(
          NodeKind::kNumber,
          Intern({TermKind::kLiteral, token_.text, rdf::IriOf(Word::kXsdNonNegativeInteger), {}},
                 point.offset),
          point);
    default:
      RefuseToken("an argument");
  }
}

OwlNode FunctionalReader::ReadLiteral() {
  const std::size_t begin = token_.begin;
  lexical_.assign(token_.text);
  Advance();
  std::string_view datatype;
  std::string_view language;
  if (token_.kind == TokenKind::kLanguage) {
    language = token_.text;
    Advance();
  } else if (token_.kind == TokenKind::kCarets) {
    Advance();
    if (!IsIri()) RefuseToken("a datatype");
    datatype = IriOf(token_, iri_);
    Advance();
  }
  try {
    return OwlNode::Leaf(NodeKind::kLiteral, axioms_.rdf().Literal(lexical_, datatype, language),
                         {begin});
  } catch (const Error& error) {
    throw WithPlace(error, At(begin));
  }
}

std::string_view FunctionalReader::IriOf(const Token& token, std::string& scratch) {
  if (token.kind == TokenKind::kFullIri) {
    if (options_.base_iri.empty() || IsAbsoluteIri(token.text)) return token.text;
    ResolveIri(token.text, options_.base_iri, scratch);
    return scratch;
  }
  const std::size_t colon = token.text.find(':');
  prefix_.assign(token.text.substr(0, colon));
  const auto row = prefixes_.find(prefix_);
  if (row == prefixes_.end()) {
    Refuse("the prefix '" + prefix_ + ":' is not declared", token.begin);
  }
  return scratch.assign(row->second).append(token.text.substr(colon + 1));
}

std::uint32_t FunctionalReader::Intern(const TermView& term, std::size_t begin) {
  try {
    return builder_.Intern(term);
  } catch (const Error& error) {
    throw WithPlace(error, At(begin));
  }
}

}  // namespace

bool IsNodeLabel(std::string_view label) {
  static constexpr ByteSet kOdd(" \t\r\n!\"#$%&'()*+,/:;<=>?@[\\]^`{|}~");
  return !label.empty() && label[0] != '-' && label[0] != '.' && label.back() != '.' &&
         kOdd.Find(label, 0) == label.size();
}

Document ReadOwlFunctional(std::string_view bytes, const ReadOptions& options) {
  return FunctionalReader(bytes, options).Read();
}

}  // namespace lares::rdf
