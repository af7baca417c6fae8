#include "ontology/rdf/xml_tokens.h"

#include <algorithm>

#include "base/text.h"

namespace lares::rdf {
namespace {

using Kind = XmlToken::Kind;
constexpr std::size_t kNowhere = std::string_view::npos;

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool IsNameByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

std::size_t XmlTokens::SkipSpace(std::size_t at) const {
  while (at < text_.size() && IsSpace(text_[at])) ++at;
  return at;
}

std::size_t XmlTokens::SkipName(std::size_t at) const {
  while (at < text_.size() && IsNameByte(text_[at])) ++at;
  return at;
}

XmlToken XmlTokens::Cut(Kind kind, std::size_t end) {
  XmlToken token;
  token.kind = kind;
  token.begin = at_;
  token.end = std::min(end, text_.size());
  at_ = kind == Kind::kBroken ? text_.size() : token.end;
  return token;
}

XmlToken XmlTokens::Until(Kind kind, std::string_view terminator, std::size_t from) {
  const std::size_t end = text_.find(terminator, from);
  if (end == kNowhere) return Cut(Kind::kBroken, text_.size());
  return Cut(kind, end + terminator.size());
}

XmlToken XmlTokens::Next() {
  if (at_ >= text_.size()) return Cut(Kind::kEnd, text_.size());
  if (in_subset_) {
    const std::size_t next = SkipSpace(at_);
    if (next > at_) return Cut(Kind::kSkipped, next);
    if (text_[at_] == ']') {
      in_subset_ = false;
      return Until(Kind::kSkipped, ">", at_);
    }
    if (text_[at_] == '%') return Until(Kind::kSkipped, ";", at_);
    if (text_[at_] != '<') return Cut(Kind::kBroken, text_.size());
  }
  if (text_[at_] != '<') return Cut(Kind::kText, std::min(text_.find('<', at_), text_.size()));
  const std::string_view rest = text_.substr(at_);
  if (rest.starts_with("<?")) return Until(Kind::kSkipped, "?>", at_ + 2);
  if (rest.starts_with("<![CDATA[")) return Until(Kind::kSkipped, "]]>", at_ + 9);
  if (rest.starts_with("<!")) return Declaration();
  return Tag();
}

XmlToken XmlTokens::Declaration() {
  const std::string_view rest = text_.substr(at_);
  if (rest.starts_with("<!--")) return Until(Kind::kComment, "-->", at_ + 4);
  const std::size_t after = SkipSpace(at_ + 2);
  if (after < text_.size() && text_[after] == '-') return Comment();
  if (rest.starts_with("<!ENTITY")) return EntityDeclaration();
  if (rest.starts_with("<!DOCTYPE")) {
    const std::size_t end = text_.find_first_of("[>", at_);
    if (end == kNowhere) return Cut(Kind::kBroken, text_.size());
    in_subset_ = text_[end] == '[';
    return Cut(Kind::kSkipped, end + 1);
  }
  return in_subset_ ? Until(Kind::kSkipped, ">", at_) : Cut(Kind::kBroken, text_.size());
}

// Ends at the first '>', which a '-' has to stand before, with no '<' between.
XmlToken XmlTokens::Comment() {
  const std::size_t end = text_.find_first_of("<>", at_ + 1);
  if (end == kNowhere || text_[end] == '<') return Cut(Kind::kBroken, text_.size());
  const std::string_view body = Trim(text_.substr(at_ + 2, end - at_ - 2));
  if (body.size() < 2 || body.back() != '-') return Cut(Kind::kBroken, text_.size());
  return Cut(Kind::kBadComment, end + 1);
}

XmlToken XmlTokens::EntityDeclaration() {
  std::size_t at = SkipSpace(at_ + 8);
  const std::size_t name_end = SkipName(at);
  const std::string_view name = text_.substr(at, name_end - at);
  at = SkipSpace(name_end);
  if (name.empty() || at >= text_.size() || (text_[at] != '"' && text_[at] != '\'')) {
    return Until(Kind::kSkipped, ">", at_);  // a parameter or external entity
  }
  const std::size_t close = text_.find(text_[at], at + 1);
  if (close == kNowhere) return Cut(Kind::kBroken, text_.size());
  const std::string_view value = text_.substr(at + 1, close - at - 1);
  XmlToken token = Until(Kind::kEntity, ">", close);
  token.name = name;
  token.value = value;
  return token;
}

XmlToken XmlTokens::Tag() {
  const bool is_end = text_.substr(at_).starts_with("</");
  const std::size_t name_at = at_ + (is_end ? 2 : 1);
  std::size_t at = SkipName(name_at);
  XmlToken tag;
  tag.name = text_.substr(name_at, at - name_at);
  if (tag.name.empty()) return Cut(Kind::kBroken, text_.size());
  while (ReadAttribute(at, tag)) {
  }
  at = SkipSpace(at);
  const bool is_empty = text_.substr(at).starts_with("/>");
  if (!is_empty && !text_.substr(at).starts_with(">")) return Cut(Kind::kBroken, text_.size());
  const Kind kind = is_end ? Kind::kEndTag : is_empty ? Kind::kEmptyTag : Kind::kStartTag;
  XmlToken token = Cut(kind, at + (is_empty ? 2 : 1));
  token.name = tag.name;
  token.attributes = std::move(tag.attributes);
  return token;
}

bool XmlTokens::ReadAttribute(std::size_t& at, XmlToken& tag) const {
  XmlToken::Attribute attribute;
  attribute.begin = at;
  const std::size_t name_at = SkipSpace(at);
  const std::size_t name_end = SkipName(name_at);
  if (name_end == name_at) return false;
  attribute.name = text_.substr(name_at, name_end - name_at);
  std::size_t next = SkipSpace(name_end);
  if (next >= text_.size() || text_[next] != '=') return false;
  next = SkipSpace(next + 1);
  if (next >= text_.size() || (text_[next] != '"' && text_[next] != '\'')) return false;
  const std::size_t close = text_.find(text_[next], next + 1);
  if (close == kNowhere) return false;
  attribute.value = text_.substr(next + 1, close - next - 1);
  if (attribute.value.find('<') != kNowhere) return false;
  attribute.end = at = close + 1;
  tag.attributes.push_back(attribute);
  return true;
}

}  // namespace lares::rdf
