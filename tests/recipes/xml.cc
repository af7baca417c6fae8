#include "tests/recipes/xml.h"

#include <cctype>
#include <stdexcept>

namespace lares::testing {
namespace {

class XmlParser {
 public:
  explicit XmlParser(const std::string& text) : text_(text) {}

  XmlElement Document() {
    SkipMisc();
    XmlElement root = Element();
    SkipMisc();
    if (at_ != text_.size()) Fail("text after the root");
    return root;
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw std::runtime_error(what + " at " + std::to_string(at_));
  }
  bool At(const std::string& token) const { return text_.compare(at_, token.size(), token) == 0; }
  void Expect(const std::string& token) {
    if (!At(token)) Fail("expected " + token);
    at_ += token.size();
  }
  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  void SkipMisc() {
    for (;;) {
      SkipSpace();
      const std::string end = At("<?") ? "?>" : At("<!--") ? "-->" : "";
      if (end.empty()) return;
      const std::size_t found = text_.find(end, at_);
      if (found == std::string::npos) Fail("unterminated");
      at_ = found + end.size();
    }
  }
  std::string Name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '_' || text_[at_] == '-')) {
      ++at_;
    }
    if (at_ == start) Fail("expected a name");
    return text_.substr(start, at_ - start);
  }
  std::string Text(char end) {
    std::string value;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == '<') Fail("bare <");
      if (text_[at_] == '&') {
        value += Reference();
      } else {
        value += text_[at_++];
      }
    }
    return value;
  }
  char Reference() {
    static const std::map<std::string, char> kNames = {{"&amp;", '&'},  {"&lt;", '<'},
                                                       {"&gt;", '>'},   {"&quot;", '"'},
                                                       {"&#10;", '\n'}, {"&#9;", '\t'}};
    for (const auto& [name, c] : kNames) {
      if (!At(name)) continue;
      at_ += name.size();
      return c;
    }
    Fail("unknown reference");
  }
  XmlElement Element() {
    Expect("<");
    XmlElement element;
    element.name = Name();
    for (SkipSpace(); !At("/>") && !At(">"); SkipSpace()) {
      const std::string name = Name();
      Expect("=");
      const std::string quote = At("'") ? "'" : "\"";
      Expect(quote);
      if (!element.attributes.emplace(name, Text(quote[0])).second) Fail("attribute twice");
      Expect(quote);
    }
    if (At("/>")) {
      at_ += 2;
      return element;
    }
    Expect(">");
    for (;;) {
      element.text += Text('<');
      SkipMisc();
      if (At("</")) break;
      element.children.push_back(Element());
    }
    Expect("</" + element.name + ">");
    return element;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

XmlElement ParseXml(const std::string& text) { return XmlParser(text).Document(); }

}  // namespace lares::testing
