// The words of a query.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"

namespace lares::sparql {

struct Token {
  enum class Kind {
    kEnd,
    kIri,       // text: between < and >
    kName,      // prefixed name; text: "prefix:local" as written
    kBlank,     // text: label
    kVariable,  // text: name
    kLanguage,  // text: tag
    kInteger,
    kDecimal,
    kDouble,
    kString,       // value: escapes resolved
    kWord,         // keyword
    kPunctuation,  // text: "{", "&&", "^^", …; "()" and "[]" with blanks between count as one
  };
  Kind kind = Kind::kEnd;
  std::string_view text;
  std::string value;
  std::size_t begin = 0;
  std::size_t end = 0;

  bool Is(std::string_view punctuation) const {
    return kind == Kind::kPunctuation && text == punctuation;
  }
  // The keyword, in any case; `upper` is in upper case.
  bool IsWord(std::string_view upper) const;
};

// Cuts a text into tokens, one ahead. The text must outlive it.
class Tokens {
 public:
  // Throws kInvalid when the text is not UTF-8.
  Tokens(std::string_view text, std::string source);

  const Token& Peek() const { return token_; }
  Token Take();
  // Where offset `at` is, columns in characters.
  Place PlaceOf(std::size_t at) const;
  [[noreturn]] void Fail(const std::string& message, std::size_t at) const;

 private:
  void Advance();
  void SkipBlanks();
  bool ReadIri();
  bool ReadNameOrWord();
  bool ReadBlank();
  bool ReadVariable();
  bool ReadLanguage();
  bool ReadNumber();
  bool ReadString();
  bool ReadPair(char open, char close, std::string_view text);
  bool ReadPunctuation();
  std::size_t ReadLocal(std::size_t at) const;
  void ReadEscape(std::size_t& at);
  void Set(Token::Kind kind, std::size_t end, std::string_view text);
  char At(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  std::string_view text_;
  std::string source_;
  std::size_t next_ = 0;
  Token token_;
};

// The \uXXXX and \UXXXXXXXX of a text resolved, as SPARQL does before anything else (19.2). Throws
// kInvalid for those that are no characters.
std::string ResolveCodepoints(std::string_view text, const std::string& source);

}  // namespace lares::sparql
