#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/xml_text.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/writers.h"
#include "ontology/rdf/xml_names.h"

namespace lares::rdf {
namespace {

constexpr std::string_view kType = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";

// Names of RDF's namespace that are syntax: no element of that name is a class or a property.
bool IsSyntaxName(std::string_view iri) {
  static const std::set<std::string_view> kNames = {
      "RDF", "ID",       "about",     "parseType",       "resource", "nodeID",
      "li",  "datatype", "aboutEach", "aboutEachPrefix", "bagID",    "Description"};
  return iri.starts_with(kRdf) && kNames.count(iri.substr(kRdf.size())) != 0;
}

class XmlWriter {
 public:
  explicit XmlWriter(const Document& document)
      : document_(document), labels_(BlankLabels(document, &IsAsciiXmlName)) {
    for (const auto& [prefix, space] : document.prefixes) Bind(prefix, space);
    rdf_ = PrefixOf(kRdf, "rdf");
  }

  std::string Run();

 private:
  void Bind(const std::string& prefix, const std::string& space);
  const std::string& PrefixOf(std::string_view space, const std::string& wanted);
  // "owl:Class"; empty when XML cannot spell it.
  std::string NameOf(std::string_view iri);
  void WriteNode(std::uint32_t subject, const std::vector<const Statement*>& group);
  void WriteProperty(const Statement& statement);
  void WriteLiteral(const Term& literal, const std::string& name);
  std::string Attribute(std::string_view local, std::string_view value) const {
    return " " + rdf_ + ":" + std::string(local) + "=\"" + EscapedXml(value, XmlUse::kAttribute) +
           "\"";
  }

  const Document& document_;
  std::vector<std::string> labels_;
  std::map<std::string, std::string, std::less<>> prefix_of_;  // namespace → prefix
  std::set<std::string, std::less<>> prefixes_;
  std::string rdf_;
  std::string body_;
};

std::string XmlWriter::Run() {
  std::vector<std::uint32_t> subjects;
  std::unordered_map<std::uint32_t, std::vector<const Statement*>> groups;
  for (const Statement& statement : document_.statements) {
    auto& group = groups[statement.subject];
    if (group.empty()) subjects.push_back(statement.subject);
    group.push_back(&statement);
  }
  for (const std::uint32_t subject : subjects) WriteNode(subject, groups[subject]);
  std::map<std::string, std::string> by_prefix;
  for (const auto& [space, prefix] : prefix_of_) by_prefix.emplace(prefix, space);
  std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<" + rdf_ + ":RDF";
  for (const auto& [prefix, space] : by_prefix) {
    head += "\n    xmlns:" + prefix + "=\"" + EscapedXml(space, XmlUse::kAttribute) + "\"";
  }
  return head + ">\n\n" + body_ + "</" + rdf_ + ":RDF>\n";
}

void XmlWriter::Bind(const std::string& prefix, const std::string& space) {
  const bool is_reserved = prefix.size() >= 3 && (prefix[0] | 0x20) == 'x' &&
                           (prefix[1] | 0x20) == 'm' && (prefix[2] | 0x20) == 'l';
  if (is_reserved || !IsAsciiXmlName(prefix) || !IsAbsoluteIri(space)) return;
  if (prefix_of_.count(space) != 0) return;
  prefix_of_.emplace(space, prefix);
  prefixes_.insert(prefix);
}

const std::string& XmlWriter::PrefixOf(std::string_view space, const std::string& wanted) {
  if (const auto known = prefix_of_.find(space); known != prefix_of_.end()) return known->second;
  std::string prefix = wanted;
  for (int i = 1; prefixes_.count(prefix) != 0; ++i) prefix = wanted + std::to_string(i);
  prefixes_.insert(prefix);
  return prefix_of_.emplace(std::string(space), prefix).first->second;
}

std::string XmlWriter::NameOf(std::string_view iri) {
  const std::size_t start = XmlNameStart(iri);
  if (start == iri.size() || start == 0) return {};
  return PrefixOf(iri.substr(0, start), "ns") + ":" + std::string(iri.substr(start));
}

void XmlWriter::WriteNode(std::uint32_t subject, const std::vector<const Statement*>& group) {
  const Statement* type = nullptr;  // the one that becomes the element's name
  std::string name = rdf_ + ":Description";
  for (const Statement* statement : group) {
    const Term& object = document_.terms[statement->object];
    if (document_.terms[statement->predicate].value != kType || object.kind != TermKind::kIri ||
        IsSyntaxName(object.value)) {
      continue;
    }
    std::string spelled = NameOf(object.value);
    if (spelled.empty()) continue;
    type = statement;
    name = std::move(spelled);
    break;
  }
  const Term& term = document_.terms[subject];
  body_ += "  <" + name +
           (term.kind == TermKind::kIri ? Attribute("about", term.value)
                                        : Attribute("nodeID", labels_[subject]));
  if (type != nullptr && group.size() == 1) {
    body_ += "/>\n\n";
    return;
  }
  body_ += ">\n";
  for (const Statement* statement : group) {
    if (statement != type) WriteProperty(*statement);
  }
  body_ += "  </" + name + ">\n\n";
}

void XmlWriter::WriteProperty(const Statement& statement) {
  const std::string& predicate = document_.terms[statement.predicate].value;
  const std::string name = IsSyntaxName(predicate) ? "" : NameOf(predicate);
  if (name.empty()) {
    throw Error(Code::kInvalid, "RDF/XML cannot spell the predicate <" + predicate + ">")
        .WithHint("Turtle can");
  }
  const Term& object = document_.terms[statement.object];
  body_ += "    <" + name;
  switch (object.kind) {
    case TermKind::kIri:
      body_ += Attribute("resource", object.value) + "/>\n";
      break;
    case TermKind::kBlank:
      body_ += Attribute("nodeID", labels_[statement.object]) + "/>\n";
      break;
    case TermKind::kLiteral:
      WriteLiteral(object, name);
      break;
  }
}

void XmlWriter::WriteLiteral(const Term& literal, const std::string& name) {
  if (!IsXmlText(literal.value)) {
    throw Error(Code::kInvalid,
                "the literal " + Quoted(literal.value) + " has a character that XML cannot hold")
        .WithHint("Turtle can");
  }
  if (!literal.language.empty()) {
    body_ += " xml:lang=\"" + EscapedXml(literal.language, XmlUse::kAttribute) + "\"";
  } else if (!literal.datatype.empty()) {
    body_ += Attribute("datatype", literal.datatype);
  }
  body_ += ">" + EscapedXml(literal.value, XmlUse::kText) + "</" + name + ">\n";
}

}  // namespace

std::string WriteRdfXml(const Document& document) { return XmlWriter(document).Run(); }

}  // namespace lares::rdf
