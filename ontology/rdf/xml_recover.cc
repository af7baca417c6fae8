#include "ontology/rdf/xml_recover.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/text.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/xml_declarations.h"
#include "ontology/rdf/xml_tokens.h"

namespace lares::rdf {
namespace {

using Kind = XmlToken::Kind;
using Attribute = XmlToken::Attribute;
constexpr std::size_t kNowhere = std::string_view::npos;

bool IsBlankText(std::string_view text) { return Trim(text).empty(); }

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

class Repairer {
 public:
  Repairer(std::string_view text, const ReadOptions& options)
      : text_(text), options_(options), declared_(CollectDeclarations(text)) {
    // A binding that itself needs the entity (xmlns:p="&p;") expands to nothing and is not there.
    for (const auto& [prefix, space] : options.known_namespaces) {
      declared_.prefixes.emplace(prefix, space);
    }
  }
  RepairedXml Run();

 private:
  enum class Role { kRoot, kNode, kProperty, kLiteral };
  struct Element {
    std::string_view name;
    Role role = Role::kNode;
    std::string_view parse_type;
    std::optional<Attribute> resource;  // of a property: what has to agree with its content
    std::size_t begin = 0;
    int children = 0;
    bool has_text = false;
    std::optional<std::string> child_about;
    std::vector<std::string> rdf_prefixes;  // bound to RDF's namespace here
  };
  struct Change {
    std::size_t offset = 0;
    std::size_t length = 0;
    std::string replacement;
  };

  struct Noted {
    std::size_t offset = 0;
    RepairedXml::Repair repair;
  };

  void Comment(const XmlToken& token);
  void BadComment(const XmlToken& token);
  void References(std::string_view range);
  void Start(const XmlToken& token);
  void End(std::string_view name);
  void NodeResource(const XmlToken& token, const Element& element);
  void Content(const Element& property);
  Role RoleOf(const XmlToken& token, const Element& element) const;
  void BindPrefixes(const XmlToken& token, Element& element) const;
  // The attribute rdf:`local`, under any prefix bound to RDF's namespace.
  const Attribute* Find(const XmlToken& token, const Element& element,
                        std::string_view local) const;
  bool IsRdf(std::string_view name, const Element& element, std::string_view local) const;
  std::size_t OffsetOfView(std::string_view view) const {
    return static_cast<std::size_t>(view.data() - text_.data());
  }
  void Replace(std::size_t offset, std::size_t length, std::string replacement) {
    changes_.push_back({offset, length, std::move(replacement)});
  }
  void Note(std::size_t offset, std::string fault, std::string remedy, bool breaks_xml = true) {
    notes_.push_back({offset, {{}, std::move(fault), std::move(remedy), breaks_xml}});
  }
  [[noreturn]] void Refuse(std::size_t offset, const std::string& message) const {
    throw Error(Code::kInvalid, message, PlaceAt(text_, offset, options_.source));
  }
  RepairedXml Apply();

  std::string_view text_;
  const ReadOptions& options_;
  XmlDeclarations declared_;
  std::vector<Element> open_;
  std::vector<Change> changes_;
  std::vector<Noted> notes_;
};

RepairedXml Repairer::Run() {
  XmlTokens tokens(text_);
  for (XmlToken token = tokens.Next(); token.kind != Kind::kEnd; token = tokens.Next()) {
    switch (token.kind) {
      case Kind::kComment:
        Comment(token);
        break;
      case Kind::kBadComment:
        BadComment(token);
        break;
      case Kind::kText: {
        const std::string_view content = text_.substr(token.begin, token.end - token.begin);
        References(content);
        if (!open_.empty() && !IsBlankText(content)) open_.back().has_text = true;
        break;
      }
      case Kind::kSkipped:
        if (!open_.empty() && text_.substr(token.begin).starts_with("<![CDATA[")) {
          open_.back().has_text = true;
        }
        break;
      case Kind::kStartTag:
        Start(token);
        break;
      case Kind::kEmptyTag:
        Start(token);
        open_.pop_back();
        break;
      case Kind::kEndTag:
        End(token.name);
        break;
      default:
        break;
    }
    if (open_.size() > static_cast<std::size_t>(options_.max_depth)) break;  // refused later
  }
  return Apply();
}

// "--" inside becomes "- ", a '-' before the end goes.
void Repairer::Comment(const XmlToken& token) {
  const std::size_t begin = token.begin + 4;
  const std::string_view body = text_.substr(begin, token.end - 3 - begin);
  const bool has_dashes = body.find("--") != kNowhere;
  if (!has_dashes && !body.ends_with('-')) return;
  if (body.find("<!--") != kNowhere) {
    Refuse(token.begin, "a comment begins inside this comment: where this one ends is not clear");
  }
  std::string mended(body);
  for (std::size_t i = 1; i < mended.size(); ++i) {
    if (mended[i] == '-' && mended[i - 1] == '-') mended[i] = ' ';
  }
  if (mended.ends_with('-')) mended.back() = ' ';
  Replace(begin, body.size(), mended);
  Note(token.begin, "malformed comment: it has '--' inside", "read as part of it");
}

void Repairer::BadComment(const XmlToken& token) {
  const std::string_view whole = text_.substr(token.begin, token.end - token.begin);
  std::string body(whole.substr(2, whole.size() - 3));
  std::replace(body.begin(), body.end(), '-', ' ');
  Replace(token.begin, whole.size(), "<!--" + body + "-->");
  Note(token.begin, "malformed comment " + Quoted(whole), "read as a comment");
}

void Repairer::References(std::string_view range) {
  for (std::size_t at = 0; (at = range.find('&', at)) != kNowhere; ++at) {
    const std::size_t end = range.find_first_of("; \t\r\n&", at + 1);
    if (end == kNowhere || range[end] != ';') continue;
    const std::string_view name = range.substr(at + 1, end - at - 1);
    static const std::set<std::string_view> kBuiltIn = {"amp", "lt", "gt", "quot", "apos"};
    if (name.empty() || name[0] == '#' || kBuiltIn.count(name) != 0) continue;
    if (declared_.entities.find(name) != declared_.entities.end()) continue;
    const auto known = declared_.prefixes.find(name);
    if (known == declared_.prefixes.end()) continue;  // libxml2 refuses it
    const std::size_t offset = OffsetOfView(range) + at;
    if (!known->second) {
      Refuse(offset, "the entity " + Quoted(name) +
                         " is not declared, and the document binds the prefix to two namespaces");
    }
    Replace(offset, name.size() + 2, Escaped(*known->second));
    Note(offset, "undeclared entity " + Quoted(name),
         "read as the namespace <" + *known->second + ">");
  }
}

void Repairer::Start(const XmlToken& token) {
  Element element;
  element.name = token.name;
  element.begin = token.begin;
  if (!open_.empty()) element.rdf_prefixes = open_.back().rdf_prefixes;
  for (const Attribute& attribute : token.attributes) References(attribute.value);
  BindPrefixes(token, element);
  element.role = RoleOf(token, element);
  if (const Attribute* type = Find(token, element, "parseType")) element.parse_type = type->value;
  if (element.role == Role::kNode) NodeResource(token, element);
  if (element.role == Role::kProperty) {
    if (const Attribute* resource = Find(token, element, "resource")) element.resource = *resource;
  }
  if (!open_.empty()) {
    Element& parent = open_.back();
    ++parent.children;
    if (const Attribute* about = Find(token, element, "about")) {
      parent.child_about = declared_.Expand(about->value).value_or(std::string(about->value));
    }
  }
  open_.push_back(std::move(element));
}

void Repairer::End(std::string_view name) {
  if (open_.empty() || open_.back().name != name) return;  // libxml2 refuses it
  if (open_.back().resource) Content(open_.back());
  open_.pop_back();
}

// Striping: nodes hold properties, properties hold nodes.
Repairer::Role Repairer::RoleOf(const XmlToken& token, const Element& element) const {
  if (open_.empty()) return IsRdf(token.name, element, "RDF") ? Role::kRoot : Role::kNode;
  const Element& parent = open_.back();
  switch (parent.role) {
    case Role::kRoot:
      return Role::kNode;
    case Role::kNode:
      return Role::kProperty;
    case Role::kLiteral:
      return Role::kLiteral;
    case Role::kProperty:
      break;
  }
  if (parent.parse_type.empty() || parent.parse_type == "Collection") return Role::kNode;
  return parent.parse_type == "Resource" ? Role::kProperty : Role::kLiteral;
}

void Repairer::BindPrefixes(const XmlToken& token, Element& element) const {
  for (const Attribute& attribute : token.attributes) {
    if (!attribute.name.starts_with("xmlns")) continue;
    const std::string prefix(attribute.name.size() > 6 ? attribute.name.substr(6) : "");
    auto& prefixes = element.rdf_prefixes;
    prefixes.erase(std::remove(prefixes.begin(), prefixes.end(), prefix), prefixes.end());
    std::optional<std::string> space = declared_.Expand(attribute.value);
    // xmlns:rdf="&rdf;" with the entity undeclared is repaired to just this.
    if (!space && attribute.value == "&rdf;") space = std::string(kRdf);
    if (space == kRdf) prefixes.push_back(prefix);
  }
}

bool Repairer::IsRdf(std::string_view name, const Element& element, std::string_view local) const {
  const std::size_t colon = name.find(':');
  const std::string_view prefix = colon == kNowhere ? "" : name.substr(0, colon);
  const std::string_view rest = colon == kNowhere ? name : name.substr(colon + 1);
  return rest == local && std::find(element.rdf_prefixes.begin(), element.rdf_prefixes.end(),
                                    prefix) != element.rdf_prefixes.end();
}

const Attribute* Repairer::Find(const XmlToken& token, const Element& element,
                                std::string_view local) const {
  for (const Attribute& attribute : token.attributes) {
    if (attribute.name.find(':') != kNowhere && IsRdf(attribute.name, element, local)) {
      return &attribute;
    }
  }
  return nullptr;
}

void Repairer::NodeResource(const XmlToken& token, const Element& element) {
  const Attribute* resource = Find(token, element, "resource");
  if (resource == nullptr) return;
  const std::size_t offset = OffsetOfView(resource->name);
  for (const std::string_view other : {"about", "ID", "nodeID"}) {
    if (Find(token, element, other) != nullptr) {
      Refuse(offset, "rdf:resource on a node element that has rdf:" + std::string(other) +
                         ": which of them names it is not clear");
    }
  }
  const std::size_t local = offset + resource->name.find(':') + 1;
  Replace(local, std::string_view("resource").size(), "about");
  Note(offset, "misplaced rdf:resource on a node element", "read as rdf:about", false);
}

// A property with rdf:resource that is not an empty tag.
void Repairer::Content(const Element& property) {
  if (property.children == 0 && !property.has_text) return;
  const Attribute& resource = *property.resource;
  const std::size_t offset = OffsetOfView(resource.name);
  const std::string wanted = declared_.Expand(resource.value).value_or(std::string(resource.value));
  const bool agrees = property.children == 1 && !property.has_text && property.parse_type.empty() &&
                      property.child_about == wanted;
  if (!agrees) {
    Refuse(offset,
           "rdf:resource on a property element that has content: which of them is meant is not "
           "clear");
  }
  Replace(resource.begin, resource.end - resource.begin, "");
  Note(offset, "misplaced rdf:resource on a property element that has content",
       "dropped, because the element inside is about the same", false);
}

RepairedXml Repairer::Apply() {
  std::sort(changes_.begin(), changes_.end(),
            [](const Change& a, const Change& b) { return a.offset < b.offset; });
  RepairedXml result;
  std::size_t done = 0;
  for (const Change& change : changes_) {
    if (change.offset < done) continue;  // inside what another repair took away
    result.text += text_.substr(done, change.offset - done);
    result.text += change.replacement;
    result.edits.push_back({change.offset, change.length, change.replacement.size()});
    done = change.offset + change.length;
  }
  result.text += text_.substr(done);
  const auto by_offset = [](const Noted& a, const Noted& b) { return a.offset < b.offset; };
  std::stable_sort(notes_.begin(), notes_.end(), by_offset);
  std::size_t counted = 0;
  int line = 1;
  for (Noted& note : notes_) {
    line += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted),
                                        text_.begin() + static_cast<std::ptrdiff_t>(note.offset),
                                        '\n'));
    counted = note.offset;
    const std::size_t start = text_.substr(0, note.offset).rfind('\n') + 1;
    const int column = PlaceAt(text_.substr(start), note.offset - start, {}).column;
    note.repair.place = {options_.source, line, column};
    result.repairs.push_back(std::move(note.repair));
  }
  return result;
}

}  // namespace

RepairedXml RepairXml(std::string_view bytes, const ReadOptions& options) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    throw Error(Code::kUnsupported, "repairs need an encoding like UTF-8, not UTF-16",
                {options.source, 1, 1});
  }
  return Repairer(bytes, options).Run();
}

Error ExplainXmlError(const Error& error, std::string_view bytes, const ReadOptions& options) {
  if (!error.place() || error.code() != Code::kInvalid) return error;
  std::vector<RepairedXml::Repair> repairs;
  try {
    repairs = RepairXml(bytes, options).repairs;
  } catch (const Error&) {
    return error;
  }
  for (const RepairedXml::Repair& repair : repairs) {
    // An XML parser stops at the first fault, so one before the error's place is the error.
    const Place& place = *error.place();
    const bool is_same =
        repair.breaks_xml ? repair.place.line <= place.line : repair.place.line == place.line;
    if (!is_same) continue;
    return Error(error.code(), repair.fault, place).WithHint("it can be repaired: --recover");
  }
  return error;
}

Place OriginalPlace(const RepairedXml& repaired, std::string_view original, const Place& place) {
  if (place.line == 0 || repaired.edits.empty()) return place;
  const std::size_t target = OffsetOf(repaired.text, place.line, std::max(1, place.column));
  std::size_t before = 0;  // where the last unchanged stretch begins in the original …
  std::size_t after = 0;   // … and in the repaired text
  for (const RepairedXml::Edit& edit : repaired.edits) {
    const std::size_t edited = after + (edit.offset - before);
    if (target < edited) break;
    if (target < edited + edit.size) return PlaceAt(original, edit.offset, place.source);
    before = edit.offset + edit.length;
    after = edited + edit.size;
  }
  return PlaceAt(original, before + (target - after), place.source);
}

}  // namespace lares::rdf
