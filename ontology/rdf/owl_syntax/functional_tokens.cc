#include "ontology/rdf/owl_syntax/functional_tokens.h"

#include <algorithm>

#include "base/error.h"
#include "ontology/rdf/byte_set.h"
#include "ontology/rdf/term_checks.h"

namespace lares::rdf {
namespace {

using Token = FunctionalToken;
using Kind = Token::Kind;

constexpr ByteSet kSpace(" \t\r\n");
constexpr ByteSet kNameEnds(" \t\r\n()<>\"=#^@,;'");
constexpr ByteSet kLineEnd("\r\n");

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsAlnum(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

FunctionalToken FunctionalTokens::Next() {
  SkipBlank();
  if (at_ >= text_.size()) return {Kind::kEnd, {}, text_.size()};
  switch (text_[at_]) {
    case '(':
      return Cut(Kind::kOpen, 0, at_ + 1);
    case ')':
      return Cut(Kind::kClose, 0, at_ + 1);
    case '=':
      return Cut(Kind::kEquals, 0, at_ + 1);
    case '<':
      return FullIri();
    case '"':
      return String();
    case '@':
      return Language();
    case '^':
      if (text_.substr(at_, 2) == "^^") return Cut(Kind::kCarets, 0, at_ + 2);
      [[fallthrough]];
    default:
      return Name();
  }
}

void FunctionalTokens::SkipBlank() {
  for (;;) {
    while (at_ < text_.size() && kSpace.Has(text_[at_])) ++at_;
    if (at_ >= text_.size() || text_[at_] != '#') return;
    at_ = kLineEnd.Find(text_, at_);
  }
}

FunctionalToken FunctionalTokens::Cut(Kind kind, std::size_t skipped, std::size_t end) {
  const Token token{kind, text_.substr(at_ + skipped, end - at_ - skipped), at_};
  at_ = end;
  return token;
}

FunctionalToken FunctionalTokens::FullIri() {
  static constexpr ByteSet kEnds("> \t\r\n<\"");
  const std::size_t end = kEnds.Find(text_, at_ + 1);
  if (end >= text_.size() || text_[end] != '>') {
    const bool is_blank = end < text_.size() && kSpace.Has(text_[end]);
    const std::string why = end >= text_.size() ? "an IRI that '<' begins does not end"
                            : is_blank
                                ? "white space in an IRI"
                                : "the character '" + std::string(1, text_[end]) + "' in an IRI";
    at_ = std::min(end, text_.size());
    throw Error(Code::kInvalid, why);
  }
  Token token = Cut(Kind::kFullIri, 1, end);
  ++at_;
  return token;
}

FunctionalToken FunctionalTokens::String() {
  static constexpr ByteSet kStops("\"\\");
  const std::size_t begin = at_;
  std::size_t done = begin + 1;  // up to here it is in `unescaped_`, or nothing was escaped
  bool is_escaped = false;
  std::size_t stop = kStops.Find(text_, done);
  while (stop < text_.size() && text_[stop] == '\\') {
    const char escaped = stop + 1 < text_.size() ? text_[stop + 1] : '\0';
    if (escaped != '"' && escaped != '\\') {
      at_ = stop;
      throw Error(Code::kInvalid, "only \\\" and \\\\ are escapes in functional syntax");
    }
    if (!is_escaped) unescaped_.clear();
    is_escaped = true;
    unescaped_.append(text_.substr(done, stop - done));
    done = stop + 1;
    stop = kStops.Find(text_, stop + 2);
  }
  if (stop >= text_.size()) throw Error(Code::kInvalid, "the string that begins here does not end");
  Token token{Kind::kString, text_.substr(done, stop - done), begin};
  if (is_escaped) token.text = unescaped_.append(token.text);
  at_ = stop + 1;
  return token;
}

FunctionalToken FunctionalTokens::Language() {
  std::size_t end = at_ + 1;
  while (end < text_.size() && (IsAlnum(text_[end]) || text_[end] == '-')) ++end;
  if (end == at_ + 1) throw Error(Code::kInvalid, "'@' begins no language tag");
  return Cut(Kind::kLanguage, 1, end);
}

FunctionalToken FunctionalTokens::Name() {
  const std::size_t end = kNameEnds.Find(text_, at_);
  const std::string_view name = text_.substr(at_, end - at_);
  if (name.empty()) {
    throw Error(Code::kInvalid,
                "the character '" + std::string(1, text_[at_]) + "' has no meaning here");
  }
  if (name.starts_with("_:")) return Cut(Kind::kNode, 2, end);
  if (name.find(':') != std::string_view::npos) return Cut(Kind::kShortIri, 0, end);
  const bool is_number = std::all_of(name.begin(), name.end(), IsDigit);
  return Cut(is_number ? Kind::kNumber : Kind::kName, 0, end);
}

std::string Describe(const FunctionalToken& token) {
  switch (token.kind) {
    case Kind::kEnd:
      return "the end of the text";
    case Kind::kString:
      return "a string";
    case Kind::kFullIri:
      return "the IRI " + Quoted(token.text);
    case Kind::kNode:
      return "the anonymous individual " + Quoted("_:" + std::string(token.text));
    case Kind::kLanguage:
      return "the language " + Quoted(token.text);
    default:
      return Quoted(token.text);
  }
}

}  // namespace lares::rdf
