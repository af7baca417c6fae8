#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/inline_blanks.h"
#include "ontology/rdf/jsonld_context.h"
#include "ontology/rdf/jsonld_numbers.h"
#include "ontology/rdf/jsonld_value.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/writers.h"

namespace lares::rdf {
namespace {

using Json = nlohmann::ordered_json;

// What is nested deeper is written beside, with a label.
constexpr int kDeepestInline = 40;

// A prefix of ours is a term that means a namespace and nothing else.
bool IsPrefixName(const std::string& name) {
  return !name.empty() && name != "_" && name[0] != '@' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

// The statements as nodes (JSON-LD 1.1 API, 8.4: serialisation from RDF), names shortened by the
// document's prefixes, lists as @list, blank nodes that are used once inside what uses them.
class JsonLdWriter {
 public:
  explicit JsonLdWriter(const Document& document)
      : document_(document),
        labels_(BlankLabels(document, &IsBlankLabel)),
        inlined_(FindInlineBlanks(document)) {
    ChoosePrefixes();
  }

  std::string Run();

 private:
  using Group = std::vector<const Statement*>;
  struct GraphNodes {
    std::vector<std::uint32_t> subjects;  // in order
    std::unordered_map<std::uint32_t, Group> of;
  };

  void ChoosePrefixes();
  std::string NameOf(std::uint32_t index) const;
  std::string Shorten(const std::string& iri) const;
  Json NodesOf(GraphNodes& nodes);
  void Describe(const GraphNodes& nodes, std::uint32_t subject, int depth, Json& node);
  Json ValueOf(const GraphNodes& nodes, std::uint32_t index, int depth);
  Json ListOf(const GraphNodes& nodes, std::uint32_t head, int depth);
  Json LiteralOf(const Term& literal) const;
  bool IsNil(const Term& term) const {
    return term.kind == TermKind::kIri && term.value == std::string(kRdf) + "nil";
  }

  const Document& document_;
  std::vector<std::string> labels_;
  InlineBlanks inlined_;
  std::map<std::string, std::string> prefixes_;                // prefix → namespace
  std::unordered_map<std::string, std::string> of_namespace_;  // namespace → prefix
  std::set<std::size_t, std::greater<>> lengths_;              // of the namespaces
  std::vector<std::uint32_t> postponed_;  // blank nodes that were nested too deep
};

// An IRI whose scheme is spelled like a prefix would be taken for a shortened one.
void JsonLdWriter::ChoosePrefixes() {
  for (const auto& [prefix, space] : document_.prefixes) {
    if (IsPrefixName(prefix) && IsAbsoluteIri(space)) prefixes_.emplace(prefix, space);
  }
  for (const Term& term : document_.terms) {
    for (const std::string* iri : {&term.value, &term.datatype}) {
      const std::size_t colon = iri->find(':');
      if (colon == std::string::npos || (iri == &term.value && term.kind != TermKind::kIri))
        continue;
      prefixes_.erase(iri->substr(0, colon));
    }
  }
  for (const auto& [prefix, space] : prefixes_) {
    of_namespace_.emplace(space, prefix);
    lengths_.insert(space.size());
  }
}

std::string JsonLdWriter::Shorten(const std::string& iri) const {
  for (const std::size_t length : lengths_) {
    if (length >= iri.size()) continue;
    const auto found = of_namespace_.find(iri.substr(0, length));
    if (found == of_namespace_.end()) continue;
    const std::string rest = iri.substr(length);
    if (!rest.starts_with("//")) return found->second + ":" + rest;
  }
  return iri;
}

std::string JsonLdWriter::NameOf(std::uint32_t index) const {
  const Term& term = document_.terms[index];
  return term.kind == TermKind::kBlank ? "_:" + labels_[index] : Shorten(term.value);
}

Json JsonLdWriter::LiteralOf(const Term& literal) const {
  if (!literal.language.empty()) {
    return {{"@value", literal.value}, {"@language", literal.language}};
  }
  if (literal.datatype.empty()) return literal.value;
  if (literal.datatype == std::string(kXsd) + "boolean") {
    if (literal.value == "true") return true;
    if (literal.value == "false") return false;
  }
  if (literal.datatype == std::string(kXsd) + "integer" && literal.value.size() <= 15) {
    const long long number = std::strtoll(literal.value.c_str(), nullptr, 10);
    if (std::to_string(number) == literal.value) return number;
  }
  if (literal.datatype == std::string(kRdf) + "JSON") {
    try {
      const jsonld::Value value = jsonld::ParseJson(literal.value, {});
      if (jsonld::Canonical(value) == literal.value) {
        return {{"@value", Json::parse(literal.value)}, {"@type", "@json"}};
      }
    } catch (const std::exception&) {
      // No JSON, or one that would not come back as it was: written as text.
    }
  }
  return {{"@value", literal.value}, {"@type", Shorten(literal.datatype)}};
}

Json JsonLdWriter::ListOf(const GraphNodes& nodes, std::uint32_t head, int depth) {
  Json items = Json::array();
  for (std::uint32_t cell = head; !IsNil(document_.terms[cell]);) {
    std::uint32_t rest = cell;
    for (const Statement* statement : nodes.of.at(cell)) {
      if (document_.terms[statement->predicate].value == std::string(kRdf) + "first") {
        items.push_back(ValueOf(nodes, statement->object, depth + 1));
      } else {
        rest = statement->object;
      }
    }
    cell = rest;
  }
  return {{"@list", items}};
}

Json JsonLdWriter::ValueOf(const GraphNodes& nodes, std::uint32_t index, int depth) {
  const Term& term = document_.terms[index];
  if (term.kind == TermKind::kLiteral) return LiteralOf(term);
  if (IsNil(term)) return {{"@list", Json::array()}};
  if (inlined_.is_inline[index] && depth >= kDeepestInline) {
    postponed_.push_back(index);
  } else if (inlined_.is_list[index]) {
    return ListOf(nodes, index, depth);
  } else if (inlined_.is_inline[index]) {
    Json node = Json::object();
    Describe(nodes, index, depth + 1, node);
    return node;
  }
  return {{"@id", NameOf(index)}};
}

void JsonLdWriter::Describe(const GraphNodes& nodes, std::uint32_t subject, int depth, Json& node) {
  const auto group = nodes.of.find(subject);
  if (group == nodes.of.end()) return;
  std::vector<std::pair<std::string, Json>> members;
  std::unordered_map<std::string, std::size_t> known;
  for (const Statement* statement : group->second) {
    const Term& object = document_.terms[statement->object];
    const std::string& predicate = document_.terms[statement->predicate].value;
    const bool is_type =
        predicate == std::string(kRdf) + "type" && object.kind != TermKind::kLiteral &&
        !(object.kind == TermKind::kBlank && inlined_.is_inline[statement->object]) &&
        !IsNil(object);
    const std::string key = is_type ? "@type" : Shorten(predicate);
    const auto [at, is_new] = known.emplace(key, members.size());
    if (is_new) members.emplace_back(key, Json::array());
    members[at->second].second.push_back(is_type ? Json(NameOf(statement->object))
                                                 : ValueOf(nodes, statement->object, depth));
  }
  for (auto& [key, values] : members) {
    node.push_back({key, values.size() == 1 ? values[0] : std::move(values)});
  }
}

Json JsonLdWriter::NodesOf(GraphNodes& nodes) {
  Json array = Json::array();
  const auto write = [&](std::uint32_t subject) {
    Json node = Json::object();
    if (!inlined_.is_unnamed[subject]) node["@id"] = NameOf(subject);
    Describe(nodes, subject, 0, node);
    array.push_back(std::move(node));
  };
  for (const std::uint32_t subject : nodes.subjects) {
    if (!inlined_.is_inline[subject]) write(subject);
  }
  while (!postponed_.empty()) {
    const std::uint32_t subject = postponed_.back();
    postponed_.pop_back();
    write(subject);
  }
  return array;
}

std::string JsonLdWriter::Run() {
  std::vector<std::uint32_t> order;  // of the graphs
  std::unordered_map<std::uint32_t, GraphNodes> graphs;
  order.push_back(Statement::kDefaultGraph);
  graphs[Statement::kDefaultGraph];
  for (const Statement& statement : document_.statements) {
    if (graphs.count(statement.graph) == 0) order.push_back(statement.graph);
    GraphNodes& nodes = graphs[statement.graph];
    Group& group = nodes.of[statement.subject];
    if (group.empty()) nodes.subjects.push_back(statement.subject);
    group.push_back(&statement);
  }
  Json root = Json::object();
  if (!prefixes_.empty()) {
    Json& context = root["@context"] = Json::object();
    for (const auto& [prefix, space] : prefixes_) {
      const bool is_plain = std::string_view(":/?#[]@").find(space.back()) != std::string::npos;
      context[prefix] = is_plain ? Json(space) : Json{{"@id", space}, {"@prefix", true}};
    }
  }
  Json nodes = Json::array();
  for (const std::uint32_t graph : order) {
    Json of_graph = NodesOf(graphs[graph]);
    if (graph == Statement::kDefaultGraph) {
      nodes = std::move(of_graph);
    } else {
      nodes.push_back({{"@id", NameOf(graph)}, {"@graph", std::move(of_graph)}});
    }
  }
  root["@graph"] = std::move(nodes);
  return root.dump(1) + "\n";
}

}  // namespace

std::string WriteJsonLd(const Document& document) { return JsonLdWriter(document).Run(); }

}  // namespace lares::rdf
