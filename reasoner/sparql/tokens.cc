#include "reasoner/sparql/tokens.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "reasoner/sparql/unicode.h"

namespace lares::sparql {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsHex(char c) { return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// PN_CHARS_BASE of the grammar.
bool IsNameStart(char32_t c) {
  constexpr std::array<std::pair<char32_t, char32_t>, 14> kRanges = {{{'A', 'Z'},
                                                                      {'a', 'z'},
                                                                      {0xC0, 0xD6},
                                                                      {0xD8, 0xF6},
                                                                      {0xF8, 0x2FF},
                                                                      {0x370, 0x37D},
                                                                      {0x37F, 0x1FFF},
                                                                      {0x200C, 0x200D},
                                                                      {0x2070, 0x218F},
                                                                      {0x2C00, 0x2FEF},
                                                                      {0x3001, 0xD7FF},
                                                                      {0xF900, 0xFDCF},
                                                                      {0xFDF0, 0xFFFD},
                                                                      {0x10000, 0xEFFFF}}};
  for (const auto& [first, last] : kRanges) {
    if (c >= first && c <= last) return true;
  }
  return false;
}

bool IsVariableCharacter(char32_t c) {
  return IsNameStart(c) || c == '_' || (c >= '0' && c <= '9') || c == 0xB7 ||
         (c >= 0x300 && c <= 0x36F) || c == 0x203F || c == 0x2040;
}

// PN_CHARS.
bool IsNameCharacter(char32_t c) { return IsVariableCharacter(c) || c == '-'; }

// The end of a run of PN_CHARS and '.' from `at` that does not end in '.'.
std::size_t EndOfName(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (at < text.size()) {
    const char32_t c = NextCharacter(text, at);
    if (IsNameCharacter(c)) {
      end = at;
    } else if (c != '.') {
      break;
    }
  }
  return end;
}

Place PlaceIn(std::string_view text, std::size_t at, const std::string& source) {
  Place place{source, 1, 1};
  for (std::size_t i = 0; i < at && i < text.size(); ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) {
      ++place.column;
    }
  }
  return place;
}

}  // namespace

bool Token::IsWord(std::string_view upper) const {
  if (kind != Kind::kWord || text.size() != upper.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i] >= 'a' && text[i] <= 'z' ? static_cast<char>(text[i] - 32) : text[i];
    if (c != upper[i]) return false;
  }
  return true;
}

Tokens::Tokens(std::string_view text, std::string source)
    : text_(text), source_(std::move(source)) {
  if (!IsUtf8(text_)) Fail("the query is not UTF-8", 0);
  if (text_.starts_with("\xEF\xBB\xBF")) next_ = 3;
  Advance();
}

Token Tokens::Take() {
  Token taken = std::move(token_);
  Advance();
  return taken;
}

Place Tokens::PlaceOf(std::size_t at) const { return PlaceIn(text_, at, source_); }

void Tokens::Fail(const std::string& message, std::size_t at) const {
  throw Error(Code::kInvalid, message, PlaceOf(at));
}

void Tokens::Set(Token::Kind kind, std::size_t end, std::string_view text) {
  token_.kind = kind;
  token_.text = text;
  token_.end = end;
  next_ = end;
}

void Tokens::SkipBlanks() {
  for (; next_ < text_.size(); ++next_) {
    const char c = text_[next_];
    if (c == '#') {
      while (next_ < text_.size() && text_[next_] != '\n' && text_[next_] != '\r') ++next_;
      if (next_ == text_.size()) return;
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
      return;
    }
  }
}

void Tokens::Advance() {
  SkipBlanks();
  token_ = Token{};
  token_.begin = next_;
  token_.end = next_;
  if (next_ >= text_.size()) return;
  if (ReadIri() || ReadBlank() || ReadNameOrWord() || ReadVariable() || ReadLanguage() ||
      ReadNumber() || ReadString() || ReadPair('(', ')', "()") || ReadPair('[', ']', "[]") ||
      ReadPunctuation()) {
    return;
  }
  std::size_t end = next_;
  NextCharacter(text_, end);
  Fail("'" + std::string(text_.substr(next_, end - next_)) + "' has no place in a query", next_);
}

bool Tokens::ReadIri() {
  if (text_[next_] != '<') return false;
  for (std::size_t i = next_ + 1; i < text_.size(); ++i) {
    const char c = text_[i];
    if (c == '>') {
      Set(Token::Kind::kIri, i + 1, text_.substr(next_ + 1, i - next_ - 1));
      return true;
    }
    if (static_cast<unsigned char>(c) <= 0x20 ||
        std::string_view("<\"{}|^`\\").find(c) != std::string_view::npos) {
      return false;
    }
  }
  return false;
}

// The end of a PN_LOCAL that begins at `at`.
std::size_t Tokens::ReadLocal(std::size_t at) const {
  std::size_t end = at;
  while (at < text_.size()) {
    const std::size_t begin = at;
    const char32_t c = NextCharacter(text_, at);
    if (c == '%') {
      if (!IsHex(At(at)) || !IsHex(At(at + 1))) break;
      end = at += 2;
    } else if (c == '\\') {
      if (std::string_view("_~.-!$&'()*+,;=/?#@%").find(At(at)) == std::string_view::npos) break;
      end = at += 1;
    } else if (c == '.' && begin != end) {
      continue;
    } else if (c == '.') {
      if (begin == token_.end) break;  // a name does not begin with '.'
    } else if (c == ':' || IsNameCharacter(c)) {
      if (c == '-' && begin == token_.end) break;
      end = at;
    } else {
      break;
    }
  }
  return end;
}

bool Tokens::ReadNameOrWord() {
  std::size_t after = next_;
  const char32_t first = NextCharacter(text_, after);
  if (!IsNameStart(first) && first != ':' && first != '_') return false;
  const std::size_t prefix = first == ':' ? next_ : EndOfName(text_, after);
  if (first != '_' && At(prefix) == ':') {
    token_.end = prefix + 1;
    const std::size_t end = ReadLocal(prefix + 1);
    Set(Token::Kind::kName, end, text_.substr(next_, end - next_));
    return true;
  }
  std::size_t end = next_;
  while (IsLetter(At(end)) || IsDigit(At(end)) || At(end) == '_') ++end;
  if (end == next_) return false;
  Set(Token::Kind::kWord, end, text_.substr(next_, end - next_));
  return true;
}

bool Tokens::ReadBlank() {
  if (At(next_) != '_' || At(next_ + 1) != ':') return false;
  const std::size_t begin = next_ + 2;
  std::size_t after = begin;
  const char32_t first = NextCharacter(text_, after);
  if (!IsNameStart(first) && first != '_' && !(first >= '0' && first <= '9')) return false;
  const std::size_t end = std::max(after, EndOfName(text_, after));
  Set(Token::Kind::kBlank, end, text_.substr(begin, end - begin));
  return true;
}

bool Tokens::ReadVariable() {
  if (At(next_) != '?' && At(next_) != '$') return false;
  std::size_t end = next_ + 1;
  for (std::size_t at = end; at < text_.size(); end = at) {
    const char32_t c = NextCharacter(text_, at);
    const bool is_start = IsNameStart(c) || c == '_' || (c >= '0' && c <= '9');
    if (!(end == next_ + 1 ? is_start : IsVariableCharacter(c))) break;
  }
  if (end == next_ + 1) return false;
  Set(Token::Kind::kVariable, end, text_.substr(next_ + 1, end - next_ - 1));
  return true;
}

bool Tokens::ReadLanguage() {
  if (At(next_) != '@' || !IsLetter(At(next_ + 1))) return false;
  std::size_t end = next_ + 1;
  while (IsLetter(At(end))) ++end;
  while (At(end) == '-' && (IsLetter(At(end + 1)) || IsDigit(At(end + 1)))) {
    ++end;
    while (IsLetter(At(end)) || IsDigit(At(end))) ++end;
  }
  Set(Token::Kind::kLanguage, end, text_.substr(next_ + 1, end - next_ - 1));
  return true;
}

bool Tokens::ReadNumber() {
  std::size_t end = next_;
  while (IsDigit(At(end))) ++end;
  const bool has_whole = end > next_;
  Token::Kind kind = Token::Kind::kInteger;
  std::size_t fraction = end;
  if (At(end) == '.') {
    ++fraction;
    while (IsDigit(At(fraction))) ++fraction;
  }
  const bool has_fraction = fraction > end + 1;
  if (!has_whole && !has_fraction) return false;
  const auto exponent_end = [&](std::size_t at) -> std::size_t {
    if (At(at) != 'e' && At(at) != 'E') return 0;
    ++at;
    if (At(at) == '+' || At(at) == '-') ++at;
    const std::size_t digits = at;
    while (IsDigit(At(at))) ++at;
    return at > digits ? at : 0;
  };
  if (const std::size_t with_exponent = exponent_end(fraction)) {
    kind = Token::Kind::kDouble;
    end = with_exponent;
  } else if (has_fraction) {
    kind = Token::Kind::kDecimal;
    end = fraction;
  }
  Set(kind, end, text_.substr(next_, end - next_));
  return true;
}

void Tokens::ReadEscape(std::size_t& at) {
  constexpr std::string_view kNames = "tbnrf\\\"'";
  constexpr std::string_view kValues = "\t\b\n\r\f\\\"'";
  const std::size_t which = kNames.find(At(at + 1));
  if (which == std::string_view::npos || at + 1 >= text_.size()) {
    Fail("a string has an unknown escape", at);
  }
  token_.value += kValues[which];
  at += 2;
}

bool Tokens::ReadString() {
  const char quote = text_[next_];
  if (quote != '"' && quote != '\'') return false;
  const std::string three(3, quote);
  const bool is_long = text_.substr(next_).starts_with(three);
  for (std::size_t i = next_ + (is_long ? 3 : 1); i < text_.size();) {
    const char c = text_[i];
    if (c == '\\') {
      ReadEscape(i);
      continue;
    }
    if (c == quote && (!is_long || text_.substr(i).starts_with(three))) {
      Set(Token::Kind::kString, i + (is_long ? 3 : 1), {});
      return true;
    }
    if (!is_long && (c == '\n' || c == '\r')) Fail("a string does not end on its line", next_);
    token_.value += c;
    ++i;
  }
  Fail("a string does not end", next_);
}

bool Tokens::ReadPair(char open, char close, std::string_view text) {
  if (At(next_) != open) return false;
  std::size_t at = next_ + 1;
  while (At(at) != '\0' && std::string_view(" \t\r\n").find(At(at)) != std::string_view::npos) ++at;
  if (At(at) != close) return false;
  Set(Token::Kind::kPunctuation, at + 1, text);
  return true;
}

bool Tokens::ReadPunctuation() {
  constexpr std::array<std::string_view, 6> kTwo = {"^^", "||", "&&", "!=", "<=", ">="};
  for (const std::string_view two : kTwo) {
    if (text_.substr(next_, 2) == two) {
      Set(Token::Kind::kPunctuation, next_ + 2, two);
      return true;
    }
  }
  if (std::string_view("{}()[].,;*/+-|^!?=<>").find(text_[next_]) == std::string_view::npos) {
    return false;
  }
  Set(Token::Kind::kPunctuation, next_ + 1, text_.substr(next_, 1));
  return true;
}

std::string ResolveCodepoints(std::string_view text, const std::string& source) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (text[i] != '\\' || (next != 'u' && next != 'U')) {
      const std::size_t length = text[i] == '\\' && next == '\\' ? 2 : 1;
      out.append(text.substr(i, length));
      i += length;
      continue;
    }
    const std::size_t digits = next == 'u' ? 4 : 8;
    char32_t c = 0;
    bool is_valid = i + 2 + digits <= text.size();
    for (std::size_t k = 0; is_valid && k < digits; ++k) {
      const char digit = text[i + 2 + k];
      is_valid = IsHex(digit);
      c = c * 16 + static_cast<char32_t>(IsDigit(digit) ? digit - '0' : (digit | 32) - 'a' + 10);
    }
    if (!is_valid || c == 0 || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) {
      throw Error(Code::kInvalid, "a \\u escape is no character", PlaceIn(text, i, source));
    }
    AppendCharacter(c, out);
    i += 2 + digits;
  }
  return out;
}

}  // namespace lares::sparql
