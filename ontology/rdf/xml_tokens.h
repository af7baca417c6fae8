// The markup of an XML text as byte ranges: forgiving, so that faults can be seen and repaired.
// For encodings that agree with ASCII on markup (UTF-8, ISO-8859-1).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace lares::rdf {

struct XmlToken {
  enum class Kind {
    kText,
    kComment,     // "<!--" up to the first "-->"
    kBadComment,  // "<!-x-->", "<! -- x -->": meant as a comment
    kEntity,      // <!ENTITY name "value">: name and value filled
    kSkipped,     // processing instruction, CDATA, the rest of a document type
    kStartTag,
    kEmptyTag,  // <a/>
    kEndTag,
    kBroken,  // nothing that is known, up to the end of the text
    kEnd,
  };
  struct Attribute {
    std::size_t begin = 0;  // with the white space before it
    std::size_t end = 0;
    std::string_view name;
    std::string_view value;  // as written, without quotes
  };

  Kind kind = Kind::kEnd;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string_view name;
  std::string_view value;
  std::vector<Attribute> attributes;
};

class XmlTokens {
 public:
  explicit XmlTokens(std::string_view text) : text_(text) {}
  // kEnd once the text is used up, kBroken (then kEnd) at the first thing that is no token.
  XmlToken Next();

 private:
  XmlToken Cut(XmlToken::Kind kind, std::size_t end);
  XmlToken Until(XmlToken::Kind kind, std::string_view terminator, std::size_t from);
  XmlToken Declaration();
  XmlToken Comment();
  XmlToken EntityDeclaration();
  XmlToken Tag();
  bool ReadAttribute(std::size_t& at, XmlToken& tag) const;
  std::size_t SkipSpace(std::size_t at) const;
  std::size_t SkipName(std::size_t at) const;

  std::string_view text_;
  std::size_t at_ = 0;
  bool in_subset_ = false;  // between [ and ] of the document type
};

}  // namespace lares::rdf
