#include "tests/reasoner/sparql/w3c_results.h"

#include <libxml/xmlreader.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/value.h"
#include "tests/ontology/isomorphism.h"

namespace lares::sparql::testing {
namespace {

using rdf::Document;
using rdf::Term;
using rdf::TermKind;

constexpr std::string_view kResultSet = "http://www.w3.org/2001/sw/DataAccess/tests/result-set#";

Term TypedTerm(const std::string& type, const std::string& value, const std::string& datatype,
               const std::string& language) {
  if (type == "uri") return Term::Iri(value);
  if (type == "bnode") return Term::Blank(value);
  return Term::Literal(value, datatype == kXsdString ? "" : datatype, ToLower(language));
}

std::string Attribute(xmlTextReaderPtr reader, const char* name) {
  xmlChar* text = xmlTextReaderGetAttribute(reader, reinterpret_cast<const xmlChar*>(name));
  const std::string value = text == nullptr ? "" : reinterpret_cast<const char*>(text);
  xmlFree(text);
  return value;
}

Expected ReadXml(const std::string& text) {
  Expected expected;
  xmlTextReaderPtr reader = xmlReaderForMemory(text.data(), static_cast<int>(text.size()), nullptr,
                                               nullptr, XML_PARSE_NONET);
  std::string variable, type, datatype, language, value;
  bool in_value = false;
  while (xmlTextReaderRead(reader) == 1) {
    const int node = xmlTextReaderNodeType(reader);
    const xmlChar* raw = xmlTextReaderConstLocalName(reader);
    const std::string name = raw == nullptr ? "" : reinterpret_cast<const char*>(raw);
    const bool is_value =
        name == "uri" || name == "bnode" || name == "literal" || name == "boolean";
    bool is_end = node == XML_READER_TYPE_END_ELEMENT;
    if (node == XML_READER_TYPE_ELEMENT) {
      if (name == "variable") expected.variables.push_back(Attribute(reader, "name"));
      if (name == "result") expected.rows.emplace_back();
      if (name == "binding") variable = Attribute(reader, "name");
      if (is_value) {
        type = name;
        datatype = Attribute(reader, "datatype");
        language = Attribute(reader, "xml:lang");
        value.clear();
        in_value = true;
        is_end = xmlTextReaderIsEmptyElement(reader) == 1;
      }
    } else if (in_value && xmlTextReaderConstValue(reader) != nullptr) {
      value += reinterpret_cast<const char*>(xmlTextReaderConstValue(reader));
    }
    if (is_end && is_value) {
      in_value = false;
      if (name == "boolean") {
        expected.yes = Trim(value) == "true";
      } else {
        expected.rows.back()[variable] = TypedTerm(type, value, datatype, language);
      }
    }
  }
  xmlFreeTextReader(reader);
  return expected;
}

Expected ReadJson(const std::string& text) {
  Expected expected;
  const nlohmann::json json = nlohmann::json::parse(text);
  if (json.contains("boolean")) {
    expected.yes = json["boolean"].get<bool>();
    return expected;
  }
  for (const auto& name : json["head"]["vars"]) expected.variables.push_back(name);
  for (const auto& binding : json["results"]["bindings"]) {
    auto& row = expected.rows.emplace_back();
    for (const auto& [name, term] : binding.items()) {
      const std::string type = term["type"];
      row[name] = TypedTerm(type == "typed-literal" ? "literal" : type, term["value"],
                            term.value("datatype", ""), term.value("xml:lang", ""));
    }
  }
  return expected;
}

// One record of CSV; `at` moves behind it.
std::vector<std::string> CsvRecord(const std::string& text, std::size_t& at) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (is_quoted) {
      if (c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
        cells.back() += '"';
        ++at;
      } else if (c == '"') {
        is_quoted = false;
      } else {
        cells.back() += c;
      }
    } else if (c == '"') {
      is_quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++at;
      return cells;
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

// CSV does not tell IRIs from literals.
Term CsvTerm(const std::string& text) {
  return text.starts_with("_:") ? Term::Blank(text.substr(2)) : Term::Literal(text);
}

Expected ReadCsv(const std::string& text) {
  Expected expected;
  expected.is_csv = true;
  std::size_t at = 0;
  expected.variables = CsvRecord(text, at);
  while (at < text.size()) {
    const std::vector<std::string> cells = CsvRecord(text, at);
    auto& row = expected.rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].empty()) continue;
      row[expected.variables[i]] = CsvTerm(cells[i]);
    }
  }
  return expected;
}

Term TurtleTerm(const std::string& text, const std::string& base_iri) {
  rdf::ReadOptions options;
  options.base_iri = base_iri;
  const Document document =
      rdf::ReadRdf("<http://s> <http://p> " + text + " .", rdf::Format::kTurtle, options);
  return document.terms[document.statements[0].object];
}

Expected ReadTsv(const std::string& text, const std::string& base_iri) {
  Expected expected;
  bool is_head = true;
  for (const std::string& line : Split(text, '\n')) {
    if (line.empty() && !is_head) continue;
    const std::vector<std::string> cells =
        Split(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line, '\t');
    if (is_head) {
      for (const std::string& cell : cells) expected.variables.push_back(cell.substr(1));
      is_head = false;
      continue;
    }
    auto& row = expected.rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!cells[i].empty()) row[expected.variables[i]] = TurtleTerm(cells[i], base_iri);
    }
  }
  return expected;
}

// Objects of a document's statements by subject and local name of the predicate.
class Properties {
 public:
  explicit Properties(const Document& document) : document_(document) {
    for (const rdf::Statement& s : document.statements) {
      const std::string& predicate = document.terms[s.predicate].value;
      if (document.terms[s.object].value == std::string(kResultSet) + "ResultSet") set_ = s.subject;
      if (!predicate.starts_with(kResultSet)) continue;
      values_[s.subject][predicate.substr(kResultSet.size())].push_back(s.object);
    }
  }
  std::vector<std::uint32_t> Get(std::uint32_t subject, const std::string& name) const {
    const auto row = values_.find(subject);
    if (row == values_.end()) return {};
    const auto value = row->second.find(name);
    return value == row->second.end() ? std::vector<std::uint32_t>{} : value->second;
  }
  std::optional<std::uint32_t> ResultSet() const { return set_; }
  const Term& At(std::uint32_t index) const { return document_.terms[index]; }

 private:
  const Document& document_;
  std::optional<std::uint32_t> set_;
  std::map<std::uint32_t, std::map<std::string, std::vector<std::uint32_t>>> values_;
};

Expected ReadGraph(const std::filesystem::path& file, const std::string& base_iri, Form form) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  options.base_iri = base_iri;
  const std::string text = ReadFile(file);
  Expected expected;
  Document document = rdf::ReadRdf(text, rdf::GuessFormat("", options.source, text), options);
  if (form == Form::kConstruct || form == Form::kDescribe) {
    expected.graph = std::move(document);
    return expected;
  }
  const Properties properties(document);
  const auto set = properties.ResultSet();
  if (!set) throw Error(Code::kInvalid, "no result set in " + options.source);
  for (const std::uint32_t name : properties.Get(*set, "resultVariable")) {
    expected.variables.push_back(properties.At(name).value);
  }
  for (const std::uint32_t yes : properties.Get(*set, "boolean")) {
    expected.yes = properties.At(yes).value == "true";
  }
  std::vector<std::pair<int, std::map<std::string, Term>>> rows;
  for (const std::uint32_t solution : properties.Get(*set, "solution")) {
    auto& [index, row] = rows.emplace_back();
    for (const std::uint32_t place : properties.Get(solution, "index")) {
      index = std::stoi(properties.At(place).value);
      expected.is_ordered = true;
    }
    for (const std::uint32_t binding : properties.Get(solution, "binding")) {
      row[properties.At(properties.Get(binding, "variable").at(0)).value] =
          properties.At(properties.Get(binding, "value").at(0));
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [index, row] : rows) expected.rows.push_back(std::move(row));
  return expected;
}

using Rows = std::vector<std::map<std::string, Term>>;

Rows RowsOf(const Answer& answer, bool as_csv) {
  Rows rows;
  for (const auto& cells : answer.rows) {
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!cells[i] || (as_csv && cells[i]->value.empty())) continue;
      const Term& term = *cells[i];
      row[answer.variables[i]] =
          !as_csv || term.kind == TermKind::kBlank ? term : Term::Literal(term.value);
    }
  }
  return rows;
}

Term ByValue(const Term& term) {
  const Value value = ValueOf(term.view(), {});
  Term canonical = term;
  if (value.kind == Value::Kind::kInteger || value.kind == Value::Kind::kDecimal) {
    canonical.value = sparql::ToText(value.decimal);
  } else if (value.kind == Value::Kind::kFloat || value.kind == Value::Kind::kDouble) {
    canonical.value = DoubleText(value.number, true);
  }
  return canonical;
}

// A row is a blank node whose properties are its columns.
Document AsDocument(const Rows& rows, bool by_value, bool in_order) {
  Document document;
  const auto add = [&](Term term) {
    document.terms.push_back(std::move(term));
    return static_cast<std::uint32_t>(document.terms.size() - 1);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name = std::to_string(i);
    const std::uint32_t row = add(in_order ? Term::Iri("row:" + name) : Term::Blank("row-" + name));
    document.statements.push_back({row, add(Term::Iri("is:row")), add(Term::Iri("is:row"))});
    for (const auto& [variable, term] : rows[i]) {
      Term value = by_value ? ByValue(term) : term;
      if (value.kind == TermKind::kBlank) value.value = "term-" + value.value;
      document.statements.push_back({row, add(Term::Iri("var:" + variable)), add(value)});
    }
  }
  return document;
}

}  // namespace

Expected ReadExpected(const std::filesystem::path& file, const std::string& base_iri, Form form) {
  const std::string extension = file.extension().string();
  if (extension == ".srx") return ReadXml(ReadFile(file));
  if (extension == ".srj") return ReadJson(ReadFile(file));
  if (extension == ".csv") return ReadCsv(ReadFile(file));
  if (extension == ".tsv") return ReadTsv(ReadFile(file), base_iri);
  return ReadGraph(file, base_iri, form);
}

Likeness Compare(const Expected& expected, const Answer& answer, bool in_order) {
  const auto same_if = [](bool is_same) {
    return is_same ? Likeness::kSame : Likeness::kDifferent;
  };
  if (answer.form == Form::kAsk) return same_if(expected.yes == answer.yes);
  if (answer.form != Form::kSelect) {
    return same_if(expected.graph && rdf::testing::AreIsomorphic(*expected.graph, answer.graph));
  }
  const std::set<std::string> wanted(expected.variables.begin(), expected.variables.end());
  const std::set<std::string> have(answer.variables.begin(), answer.variables.end());
  if (wanted != have || expected.rows.size() != answer.rows.size()) return Likeness::kDifferent;
  const Rows rows = RowsOf(answer, expected.is_csv);
  for (const bool by_value : {false, true}) {
    if (rdf::testing::AreIsomorphic(AsDocument(expected.rows, by_value, in_order),
                                    AsDocument(rows, by_value, in_order))) {
      return by_value ? Likeness::kSameByValue : Likeness::kSame;
    }
  }
  return Likeness::kDifferent;
}

namespace {

std::string RowsText(const Rows& rows) {
  std::string text;
  for (const auto& row : rows) {
    for (const auto& [name, term] : row) text += name + "=" + rdf::ToNTriples(term.view()) + "  ";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string ToText(const Expected& expected) {
  if (expected.yes) return *expected.yes ? "yes\n" : "no\n";
  if (expected.graph) return rdf::testing::Lines(*expected.graph);
  return Join(expected.variables, " ") + "\n" + RowsText(expected.rows);
}

std::string ToText(const Answer& answer) {
  if (answer.form == Form::kAsk) return answer.yes ? "yes\n" : "no\n";
  if (answer.form != Form::kSelect) return rdf::testing::Lines(answer.graph);
  return Join(answer.variables, " ") + "\n" + RowsText(RowsOf(answer, false));
}

}  // namespace lares::sparql::testing
