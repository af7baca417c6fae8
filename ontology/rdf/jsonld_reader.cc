#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/jsonld_context.h"
#include "ontology/rdf/jsonld_expand.h"
#include "ontology/rdf/jsonld_numbers.h"
#include "ontology/rdf/jsonld_value.h"
#include "ontology/rdf/parsers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

using jsonld::LooksLikeIri;
using jsonld::Object;
using jsonld::Value;

constexpr std::size_t kMostWarnings = 100;
const std::string kType = std::string(kRdf) + "type";
const std::string kFirst = std::string(kRdf) + "first";
const std::string kRest = std::string(kRdf) + "rest";
const std::string kNil = std::string(kRdf) + "nil";

// The expanded form as statements (JSON-LD 1.1 API, 8.1: deserialisation to RDF). Directions are
// ignored, and so are properties that are blank nodes.
class StatementMaker {
 public:
  StatementMaker(std::string_view text, const ReadOptions& options)
      : text_(text), options_(options), builder_(Format::kJsonLd, options) {}

  Document Run();

 private:
  [[noreturn]] void Fail(const std::string& message, std::size_t offset) const {
    throw Error(Code::kInvalid, message, PlaceAt(text_, offset, options_.source));
  }
  void Warn(const std::string& message, std::size_t offset);
  template <typename Work>
  auto At(std::size_t offset, Work&& work);

  void AddPrefixes(const Value& root);
  void Add(std::uint32_t subject, const std::string& predicate, std::uint32_t object,
           std::size_t offset);
  std::optional<std::uint32_t> ResourceOf(const std::string& name, std::size_t offset);
  std::uint32_t LineOf(std::size_t offset);
  std::uint32_t FreshBlank();
  std::uint32_t BlankOf(const std::string& label);
  std::optional<std::uint32_t> TermOf(const Object& object);
  std::optional<std::uint32_t> LiteralOf(const Object& object);
  std::uint32_t ListOf(const Object& object);
  std::optional<std::uint32_t> NodeOf(const Object& object);
  void Describe(std::optional<std::uint32_t> subject, const Object& object);

  std::string_view text_;
  const ReadOptions& options_;
  DocumentBuilder builder_;
  std::uint32_t graph_ = Statement::kDefaultGraph;
  bool drops_graph_ = false;  // inside a graph whose name is no IRI
  std::unordered_map<std::string, std::string> labels_;
  std::size_t blanks_ = 0;
  std::vector<std::size_t> line_starts_;  // made when first asked for
};

Document StatementMaker::Run() {
  const Value root = jsonld::ParseJson(text_, options_);
  if (!root.is_object() && !root.is_array()) {
    Fail("a JSON-LD document is an object or an array", root.offset);
  }
  jsonld::Expander expander(
      options_.base_iri,
      [this](const std::string& message, std::size_t offset) { Fail(message, offset); },
      [this](const std::string& message, std::size_t offset) { Warn(message, offset); });
  std::vector<Object> objects;
  try {
    objects = expander.Expand(root);
  } catch (const Error& error) {
    throw WithPlace(error, {options_.source, 0, 0});
  }
  AddPrefixes(root);
  for (const Object& object : objects) {
    if (object.is_node()) NodeOf(object);
  }
  return builder_.Finish();
}

void StatementMaker::Warn(const std::string& message, std::size_t offset) {
  auto& remarks = builder_.document().remarks;
  if (remarks.size() >= kMostWarnings) return;
  remarks.push_back({Remark::Kind::kWarning, PlaceAt(text_, offset, options_.source), message});
}

template <typename Work>
auto StatementMaker::At(std::size_t offset, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw WithPlace(error, PlaceAt(text_, offset, options_.source));
  }
}

// What the outermost contexts call namespaces by, so that it can be written so again.
void StatementMaker::AddPrefixes(const Value& root) {
  const Value* context = root.Find("@context");
  if (context == nullptr) return;
  jsonld::ForEachItem(*context, [&](const Value& one) {
    for (const jsonld::Member& member : one.members) {
      const std::string& iri = member.value.text;
      const bool is_space = member.value.is_string() && IsAbsoluteIri(iri) &&
                            (iri.ends_with('#') || iri.ends_with('/') || iri.ends_with(':'));
      if (is_space && !member.key.starts_with('@')) {
        builder_.document().prefixes[member.key] = iri;
      }
    }
  });
}

void StatementMaker::Add(std::uint32_t subject, const std::string& predicate, std::uint32_t object,
                         std::size_t offset) {
  if (drops_graph_) return;
  At(offset, [&] {
    const std::uint32_t property = builder_.Intern({TermKind::kIri, predicate, {}, {}});
    builder_.Add({subject, property, object, graph_});
    if (options_.record_lines) builder_.document().lines.push_back(LineOf(offset));
  });
}

std::uint32_t StatementMaker::LineOf(std::size_t offset) {
  if (line_starts_.empty()) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_[i] == '\n') line_starts_.push_back(i + 1);
    }
  }
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return static_cast<std::uint32_t>(next - line_starts_.begin());
}

std::uint32_t StatementMaker::FreshBlank() {
  return builder_.Intern({TermKind::kBlank, "gen" + std::to_string(++blanks_), {}, {}});
}

// Labels of the document are kept where they can be written and are not like generated ones.
std::uint32_t StatementMaker::BlankOf(const std::string& label) {
  std::string& known = labels_[label];
  if (known.empty()) {
    const bool is_kept = IsBlankLabel(label) && !label.starts_with("gen");
    known = is_kept ? label : "gen" + std::to_string(++blanks_);
  }
  return builder_.Intern({TermKind::kBlank, known, {}, {}});
}

// None for a name that makes no statement: the standard has such statements left out.
std::optional<std::uint32_t> StatementMaker::ResourceOf(const std::string& name,
                                                        std::size_t offset) {
  if (name.starts_with("_:")) {
    return At(offset, [&] { return BlankOf(name.substr(2)); });
  }
  if (IsAbsoluteIri(name)) {
    return At(offset, [&] { return builder_.Intern({TermKind::kIri, name, {}, {}}); });
  }
  if (!name.empty() && !LooksLikeIri(name) && options_.base_iri.empty() && name[0] != '@') {
    Fail("the IRI " + Quoted(name) + " is relative, and no base IRI is known", offset);
  }
  Warn(Quoted(name) + " is no IRI: what is said of it is left out", offset);
  return std::nullopt;
}

std::optional<std::uint32_t> StatementMaker::TermOf(const Object& object) {
  if (object.value != nullptr) return LiteralOf(object);
  if (object.list) return ListOf(object);
  return NodeOf(object);
}

std::optional<std::uint32_t> StatementMaker::LiteralOf(const Object& object) {
  const Value& value = *object.value;
  std::string datatype = object.types.empty() ? "" : object.types.front();
  std::string lexical = value.text;
  if (datatype == "@json") {
    lexical = jsonld::Canonical(value);
    datatype = std::string(kRdf) + "JSON";
  } else if (value.kind == Value::Kind::kBoolean) {
    lexical = value.boolean ? "true" : "false";
    if (datatype.empty()) datatype = std::string(kXsd) + "boolean";
  } else if (value.kind == Value::Kind::kNumber) {
    const jsonld::Numeral numeral =
        jsonld::ToNumeral(value.text, datatype == std::string(kXsd) + "double");
    lexical = numeral.lexical;
    if (datatype.empty()) {
      datatype = std::string(kXsd) + (numeral.is_double ? "double" : "integer");
    }
  }
  if (!datatype.empty() && !IsAbsoluteIri(datatype)) {
    Warn("the datatype " + Quoted(datatype) + " is no IRI: the value is left out", object.offset);
    return std::nullopt;
  }
  return At(object.offset, [&] {
    return builder_.Intern({TermKind::kLiteral, lexical, datatype, object.language.value_or("")});
  });
}

std::uint32_t StatementMaker::ListOf(const Object& object) {
  std::uint32_t head = builder_.Intern({TermKind::kIri, kNil, {}, {}});
  const std::uint32_t nil = head;
  std::optional<std::uint32_t> last;
  for (const Object& item : *object.list) {
    const std::optional<std::uint32_t> term = TermOf(item);
    const std::uint32_t cell = FreshBlank();
    if (last) {
      Add(*last, kRest, cell, item.offset);
    } else {
      head = cell;
    }
    if (term) Add(cell, kFirst, *term, item.offset);
    last = cell;
  }
  if (last) Add(*last, kRest, nil, object.offset);
  return head;
}

std::optional<std::uint32_t> StatementMaker::NodeOf(const Object& object) {
  const std::optional<std::uint32_t> subject =
      object.id ? ResourceOf(*object.id, object.offset) : FreshBlank();
  Describe(subject, object);
  return subject;
}

void StatementMaker::Describe(std::optional<std::uint32_t> subject, const Object& object) {
  const auto add = [&](std::optional<std::uint32_t> from, const std::string& predicate,
                       std::optional<std::uint32_t> to, std::size_t offset) {
    if (from && to) Add(*from, predicate, *to, offset);
  };
  for (const std::string& type : object.types) {
    add(subject, kType, ResourceOf(type, object.offset), object.offset);
  }
  const auto for_each_value = [&](const auto& properties, auto&& visit) {
    for (const auto& [property, values] : properties) {
      const bool is_blank = property.starts_with("_:");
      if (is_blank && !values.empty()) {
        Warn("the property " + Quoted(property) + " is a blank node, and left out", object.offset);
      }
      const bool is_said =
          !is_blank && !values.empty() && ResourceOf(property, values.front().offset).has_value();
      for (const Object& value : values) {
        const std::optional<std::uint32_t> term = TermOf(value);
        if (is_said) visit(property, term, value.offset);
      }
    }
  };
  for_each_value(object.properties, [&](const auto& property, auto term, std::size_t offset) {
    add(subject, property, term, offset);
  });
  for_each_value(object.reverse, [&](const auto& property, auto term, std::size_t offset) {
    add(term, property, subject, offset);
  });
  if (object.included) {
    for (const Object& node : *object.included) NodeOf(node);
  }
  if (!object.graph) return;
  const std::uint32_t outer = std::exchange(graph_, subject.value_or(graph_));
  const bool outer_drops = std::exchange(drops_graph_, drops_graph_ || !subject);
  for (const Object& node : *object.graph) {
    if (node.is_node()) NodeOf(node);
  }
  graph_ = outer;
  drops_graph_ = outer_drops;
}

}  // namespace

Document ReadJsonLd(std::string_view bytes, const ReadOptions& options) {
  return StatementMaker(bytes, options).Run();
}

}  // namespace lares::rdf
