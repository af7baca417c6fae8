// The tokens of OWL functional syntax (Structural Specification, section 2.3).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lares::rdf {

struct FunctionalToken {
  enum class Kind {
    kName,      // Ontology, SubClassOf, …
    kNumber,    // digits only
    kFullIri,   // text: without < and >
    kShortIri,  // a:b, :b, a:
    kNode,      // text: without "_:"
    kString,    // text: unescaped, without quotes
    kLanguage,  // text: without '@'
    kCarets,    // ^^
    kOpen,
    kClose,
    kEquals,
    kEnd,
  };

  Kind kind = Kind::kEnd;
  std::string_view text;
  std::size_t begin = 0;  // of the token in the text
};

class FunctionalTokens {
 public:
  explicit FunctionalTokens(std::string_view text) : text_(text) {}

  // kEnd for ever once the text is used up. The text of a string is good until the next string is
  // read. Throws kInvalid without a place; FaultOffset() then says where.
  FunctionalToken Next();
  std::size_t FaultOffset() const { return at_; }

 private:
  void SkipBlank();
  FunctionalToken Cut(FunctionalToken::Kind kind, std::size_t skipped, std::size_t end);
  FunctionalToken FullIri();
  FunctionalToken String();
  FunctionalToken Language();
  FunctionalToken Name();

  std::string_view text_;
  std::size_t at_ = 0;
  std::string unescaped_;
};

// How a message names the token.
std::string Describe(const FunctionalToken& token);

}  // namespace lares::rdf
