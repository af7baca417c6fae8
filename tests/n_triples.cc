#include "tests/n_triples.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/term.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::testing {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kPrefixes = {
    {{"rdf:", rdf::kRdf},
     {"rdfs:", rdf::kRdfs},
     {"owl:", rdf::kOwl},
     {"xsd:", rdf::kXsd},
     {"lares:", rdf::kLares},
     {"x:", "http://x/"}}};

void AppendUtf8(std::uint32_t code, std::string* text) {
  const auto tail = [&](int shift) {
    text->push_back(static_cast<char>(0x80 | ((code >> shift) & 0x3F)));
  };
  if (code < 0x80) {
    text->push_back(static_cast<char>(code));
  } else if (code < 0x800) {
    text->push_back(static_cast<char>(0xC0 | (code >> 6)));
    tail(0);
  } else if (code < 0x10000) {
    text->push_back(static_cast<char>(0xE0 | (code >> 12)));
    tail(6), tail(0);
  } else {
    text->push_back(static_cast<char>(0xF0 | (code >> 18)));
    tail(12), tail(6), tail(0);
  }
}

// One line's cursor.
class Line {
 public:
  Line(std::string_view text, Place place) : rest_(text), place_(std::move(place)) {}

  rdf::Term ReadTerm() {
    SkipSpace();
    if (rest_.empty()) Fail("a term is missing");
    if (rest_.front() == '<') return rdf::Term::Iri(ReadIri());
    if (rest_.front() == '"') return ReadLiteral();
    if (rest_.starts_with("_:")) return rdf::Term::Blank(ReadWord().substr(2));
    return rdf::Term::Iri(ReadPrefixed());
  }

  void ReadEnd() {
    SkipSpace();
    if (!rest_.starts_with(".")) Fail("'.' is missing");
    const std::string_view after = Trim(rest_.substr(1));
    if (!after.empty() && after.front() != '#') Fail("there is text after '.'");
  }

 private:
  [[noreturn]] void Fail(const std::string& message) const {
    throw Error(Code::kInvalid, message, place_);
  }

  void SkipSpace() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
    }
  }

  std::string_view ReadWord() {
    const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  std::string ReadIri() {
    const std::size_t end = rest_.find('>');
    if (end == std::string_view::npos) Fail("'>' is missing");
    const std::string iri(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return iri;
  }

  std::string ReadPrefixed() {
    const std::string_view word = ReadWord();
    for (const auto& [prefix, iri] : kPrefixes) {
      if (word.starts_with(prefix)) return std::string(iri).append(word.substr(prefix.size()));
    }
    Fail("\"" + std::string(word) + "\" is no term");
  }

  rdf::Term ReadLiteral() {
    const std::string lexical = ReadQuoted();
    if (rest_.starts_with("@")) {
      return rdf::Term::Literal(lexical, {}, ToLower(ReadWord().substr(1)));
    }
    if (!rest_.starts_with("^^")) return rdf::Term::Literal(lexical);
    rest_.remove_prefix(2);
    return rdf::Term::Literal(lexical, rest_.starts_with("<") ? ReadIri() : ReadPrefixed());
  }

  std::string ReadQuoted() {
    std::string text;
    rest_.remove_prefix(1);
    while (!rest_.empty() && rest_.front() != '"') {
      if (rest_.front() == '\\') {
        ReadEscape(&text);
      } else {
        text.push_back(rest_.front());
        rest_.remove_prefix(1);
      }
    }
    if (rest_.empty()) Fail("'\"' is missing");
    rest_.remove_prefix(1);
    return text;
  }

  void ReadEscape(std::string* text) {
    constexpr std::string_view kNames = "tbnrf\"'\\", kMeanings = "\t\b\n\r\f\"'\\";
    const char name = rest_.size() > 1 ? rest_[1] : '\0';
    rest_.remove_prefix(std::min<std::size_t>(2, rest_.size()));
    if (name == 'u' || name == 'U') return ReadCodePoint(name == 'u' ? 4 : 8, text);
    const std::size_t index = kNames.find(name);
    if (name == '\0' || index == std::string_view::npos) Fail("an escape is unknown");
    text->push_back(kMeanings[index]);
  }

  void ReadCodePoint(std::size_t digits, std::string* text) {
    std::uint32_t code = 0;
    const std::string_view hex = rest_.substr(0, digits);
    const auto result = std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
    if (hex.size() != digits || result.ptr != hex.data() + digits) Fail("\\u needs hex digits");
    rest_.remove_prefix(digits);
    AppendUtf8(code, text);
  }

  std::string_view rest_;
  Place place_;
};

}  // namespace

std::vector<rdf::Triple> ReadNTriples(std::string_view text, const std::string& source,
                                      rdf::Dictionary& dictionary) {
  std::vector<rdf::Triple> triples;
  int number = 0;
  for (const std::string& row : Split(text, '\n')) {
    ++number;
    const std::string_view trimmed = Trim(row);
    if (trimmed.empty() || trimmed.front() == '#') continue;
    Line line(trimmed, Place{source, number});
    const rdf::Term subject = line.ReadTerm(), predicate = line.ReadTerm(),
                    object = line.ReadTerm();
    line.ReadEnd();
    triples.push_back({dictionary.Intern(subject.view()), dictionary.Intern(predicate.view()),
                       dictionary.Intern(object.view())});
  }
  std::sort(triples.begin(), triples.end());
  triples.erase(std::unique(triples.begin(), triples.end()), triples.end());
  return triples;
}

}  // namespace lares::testing
