#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/parser.h"

namespace lares::sparql {

using syntax::Path;

// A variable as a verb is a kIri path whose node is the variable.
Path Parser::ParseVerb() {
  if (tokens_.Peek().kind == Token::Kind::kVariable) {
    Path verb;
    verb.iri = Variable(ParseVariable());
    return verb;
  }
  if (!in_template_) return ParsePath();
  Path verb;
  verb.iri = tokens_.Peek().kind == Token::Kind::kWord && tokens_.Peek().text == "a"
                 ? (tokens_.Take(), Rdf("type"))
                 : AddIri(ParseIri());
  return verb;
}

Path Parser::ParsePath() {
  const Depth depth(*this);
  Path first = ParseSequence();
  if (!tokens_.Peek().Is("|")) return first;
  Path path;
  path.kind = Path::Kind::kAlternative;
  path.parts.push_back(std::move(first));
  while (Accept("|")) path.parts.push_back(ParseSequence());
  return path;
}

Path Parser::ParseSequence() {
  Path first = ParseElement();
  if (!tokens_.Peek().Is("/")) return first;
  Path path;
  path.kind = Path::Kind::kSequence;
  path.parts.push_back(std::move(first));
  while (Accept("/")) path.parts.push_back(ParseElement());
  return path;
}

// An optional ^, a primary, an optional modifier.
Path Parser::ParseElement() {
  CountStep();
  const bool is_inverse = Accept("^");
  Path path = ParsePrimary();
  const Token& token = tokens_.Peek();
  const bool has_modifier = token.Is("?") || token.Is("*") || token.Is("+");
  if (has_modifier) {
    Path closure;
    closure.kind = token.Is("?")   ? Path::Kind::kZeroOrOne
                   : token.Is("*") ? Path::Kind::kZeroOrMore
                                   : Path::Kind::kOneOrMore;
    tokens_.Take();
    closure.parts.push_back(std::move(path));
    path = std::move(closure);
  }
  if (!is_inverse) return path;
  Path inverse;
  inverse.kind = Path::Kind::kInverse;
  inverse.parts.push_back(std::move(path));
  return inverse;
}

Path Parser::ParsePrimary() {
  if (Accept("(")) {
    Path path = ParsePath();
    Expect(")");
    return path;
  }
  if (Accept("!")) return ParseNegated();
  Path path;
  if (tokens_.Peek().kind == Token::Kind::kWord && tokens_.Peek().text == "a") {
    tokens_.Take();
    path.iri = Rdf("type");
  } else if (tokens_.Peek().kind == Token::Kind::kIri ||
             tokens_.Peek().kind == Token::Kind::kName) {
    path.iri = AddIri(ParseIri());
  } else {
    FailHere("a property");
  }
  return path;
}

Path Parser::ParseNegated() {
  Path path;
  path.kind = Path::Kind::kNegated;
  if (Accept("()")) return path;
  if (!Accept("(")) {
    ParseNegatedOne(path);
    return path;
  }
  do {
    ParseNegatedOne(path);
  } while (Accept("|"));
  Expect(")");
  return path;
}

void Parser::ParseNegatedOne(Path& path) {
  auto& list = Accept("^") ? path.not_backward : path.not_forward;
  if (tokens_.Peek().kind == Token::Kind::kWord && tokens_.Peek().text == "a") {
    tokens_.Take();
    list.push_back(Rdf("type"));
  } else {
    list.push_back(AddIri(ParseIri()));
  }
}

}  // namespace lares::sparql
