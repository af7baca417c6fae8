#include "tests/ontology/test_graph.h"

#include <cctype>
#include <map>
#include <vector>

#include "base/error.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::testing {
namespace {

using rdf::Term;
using rdf::TermKind;

class Builder {
 public:
  std::uint32_t Add(const Term& term) {
    const auto [known, is_new] = ids_.emplace(rdf::ToNTriples(term.view()), document.terms.size());
    if (is_new) document.terms.push_back(term);
    return static_cast<std::uint32_t>(known->second);
  }
  void State(std::uint32_t s, std::uint32_t p, std::uint32_t o) {
    document.statements.push_back({s, p, o});
  }
  std::uint32_t Fresh() { return Add(Term::Blank("list" + std::to_string(++fresh_))); }

  rdf::Document document;

 private:
  std::map<std::string, std::size_t> ids_;
  int fresh_ = 0;
};

std::vector<std::string> Tokens(std::string_view text) {
  std::vector<std::string> tokens;
  std::size_t i = 0;
  while (i < text.size()) {
    if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
      continue;
    }
    std::size_t end = i;
    if (text[i] == '"') {
      end = text.find('"', i + 1);
      if (end == std::string_view::npos) throw Error(Code::kInvalid, "unclosed string");
    }
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) == 0) ++end;
    tokens.emplace_back(text.substr(i, end - i));
    i = end;
  }
  return tokens;
}

std::string Expand(std::string_view name) {
  static const std::map<std::string_view, std::string_view> prefixes = {
      {"rdf", rdf::kRdf}, {"rdfs", rdf::kRdfs},   {"owl", rdf::kOwl},
      {"xsd", rdf::kXsd}, {"lares", rdf::kLares}, {"", "http://example.org/"},
  };
  if (name.starts_with('<') && name.ends_with('>')) {
    return std::string(name.substr(1, name.size() - 2));
  }
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) {
    throw Error(Code::kInvalid, "not a name: " + std::string(name));
  }
  return std::string(prefixes.at(name.substr(0, colon))) + std::string(name.substr(colon + 1));
}

Term ParseTerm(std::string_view token) {
  if (token == "a") return Term::Iri(std::string(rdf::kRdf) + "type");
  if (token.starts_with("_:")) return Term::Blank(token.substr(2));
  if (token.starts_with('"')) {
    const std::size_t end = token.rfind('"');
    const std::string_view lexical = token.substr(1, end - 1);
    const std::string_view rest = token.substr(end + 1);
    if (rest.starts_with('@')) return Term::Literal(lexical, {}, rest.substr(1));
    if (rest.starts_with("^^")) return Term::Literal(lexical, Expand(rest.substr(2)));
    return Term::Literal(lexical);
  }
  if (std::isdigit(static_cast<unsigned char>(token[0])) != 0) {
    return Term::Literal(token, Expand("xsd:nonNegativeInteger"));
  }
  return Term::Iri(Expand(token));
}

class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(Tokens(text)) {}

  rdf::Document Parse() {
    while (next_ < tokens_.size()) ParseSubject();
    return std::move(builder_.document);
  }

 private:
  std::string Take() {
    if (next_ == tokens_.size()) throw Error(Code::kInvalid, "the text ends too early");
    return tokens_[next_++];
  }

  std::uint32_t Node() {
    const std::string token = Take();
    return token == "(" ? List() : builder_.Add(ParseTerm(token));
  }

  std::uint32_t List() {
    const auto name = [this](std::string_view local) {
      return builder_.Add(Term::Iri(std::string(rdf::kRdf) + std::string(local)));
    };
    std::vector<std::uint32_t> items;
    while (tokens_.at(next_) != ")") items.push_back(Node());
    ++next_;
    std::uint32_t list = name("nil");
    for (auto item = items.rbegin(); item != items.rend(); ++item) {
      const std::uint32_t cell = builder_.Fresh();
      builder_.State(cell, name("first"), *item);
      builder_.State(cell, name("rest"), list);
      list = cell;
    }
    return list;
  }

  void ParseSubject() {
    const std::uint32_t subject = Node();
    std::uint32_t predicate = Node();
    while (true) {
      builder_.State(subject, predicate, Node());
      const std::string separator = Take();
      if (separator == ".") return;
      if (separator == ";") {
        predicate = Node();
      } else if (separator != ",") {
        throw Error(Code::kInvalid, "expected a separator, found " + separator);
      }
    }
  }

  std::vector<std::string> tokens_;
  std::size_t next_ = 0;
  Builder builder_;
};

}  // namespace

rdf::Document ParseText(std::string_view text) { return Parser(text).Parse(); }

rdf::Document ParseNTriples(std::string_view text) {
  rdf::Document document;
  std::map<std::string_view, std::uint32_t> ids;
  const auto add = [&](std::string_view token) {
    const auto [known, is_new] =
        ids.emplace(token, static_cast<std::uint32_t>(document.terms.size()));
    if (is_new) document.terms.push_back(ParseTerm(token));
    return known->second;
  };
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', first + 1);
    const std::size_t last = line.rfind(" .");
    if (first == std::string_view::npos || last == std::string_view::npos || last <= second) {
      continue;
    }
    const std::uint32_t subject = add(line.substr(0, first));
    const std::uint32_t predicate = add(line.substr(first + 1, second - first - 1));
    document.statements.push_back(
        {subject, predicate, add(line.substr(second + 1, last - second - 1))});
  }
  return document;
}

rdf::Graph GraphOf(std::string_view text, rdf::Dictionary& dictionary, std::string_view name) {
  return rdf::MakeGraph(ParseText(text), name, {}, dictionary);
}

rdf::TermId TermOf(std::string_view term, rdf::Dictionary& dictionary) {
  return dictionary.Intern(ParseTerm(term).view());
}

rdf::Triple TripleOf(std::string_view triple, rdf::Dictionary& dictionary) {
  const std::vector<std::string> tokens = Tokens(triple);
  if (tokens.size() != 3) throw Error(Code::kInvalid, "not a triple: " + std::string(triple));
  return {TermOf(tokens[0], dictionary), TermOf(tokens[1], dictionary),
          TermOf(tokens[2], dictionary)};
}

std::string ToText(const rdf::Triple& triple, const rdf::Dictionary& dictionary) {
  return rdf::ToNTriples(dictionary.Get(triple.subject)) + " " +
         rdf::ToNTriples(dictionary.Get(triple.predicate)) + " " +
         rdf::ToNTriples(dictionary.Get(triple.object));
}

}  // namespace lares::testing
