#include "reasoner/sparql/results.h"

#include <array>
#include <cstdio>
#include <utility>

#include "base/text.h"
#include "reasoner/sparql/value.h"

namespace lares::sparql {

using rdf::TermKind;
using rdf::TermView;

namespace {

constexpr std::size_t kPiece = 16u << 10;

void AppendJsonText(std::string_view text, std::string& out) {
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          char code[8];
          std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
          out += code;
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

// XML 1.0 has no way to write most control characters: they become U+FFFD.
void AppendXmlText(std::string_view text, std::string& out) {
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') {
          out += "\xEF\xBF\xBD";
        } else {
          out += c;
        }
    }
  }
}

void AppendCsvText(std::string_view text, std::string& out) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

// Numbers that Turtle reads without quotes are written so.
bool IsBareNumber(const TermView& term) {
  const std::string_view text = term.value;
  const bool has_digit = text.find_first_of("0123456789") != std::string_view::npos;
  if (!has_digit || text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) {
    return false;
  }
  const Value value = ValueOf(term, {});
  const bool has_exponent = text.find_first_of("eE") != std::string_view::npos;
  if (term.datatype == kXsdInteger) return value.kind == Value::Kind::kInteger;
  if (term.datatype == kXsdDecimal) {
    return value.kind == Value::Kind::kDecimal && text.find('.') != std::string_view::npos &&
           text.back() != '.';
  }
  return term.datatype == kXsdDouble && value.kind == Value::Kind::kDouble && has_exponent;
}

struct FormatName {
  std::string_view name;
  ResultFormat format;
};

constexpr std::array<FormatName, 12> kNames = {{
    {"application/sparql-results+json", ResultFormat::kJson},
    {"application/sparql-results+xml", ResultFormat::kXml},
    {"text/csv", ResultFormat::kCsv},
    {"text/tab-separated-values", ResultFormat::kTsv},
    {"application/json", ResultFormat::kJson},
    {"application/xml", ResultFormat::kXml},
    {"text/xml", ResultFormat::kXml},
    {"json", ResultFormat::kJson},
    {"xml", ResultFormat::kXml},
    {"csv", ResultFormat::kCsv},
    {"tsv", ResultFormat::kTsv},
    {"text/json", ResultFormat::kJson},
}};

constexpr std::string_view kXmlHead =
    "<?xml version=\"1.0\"?>\n<sparql xmlns=\"http://www.w3.org/2005/sparql-results#\">\n";

std::string Head(ResultFormat format, const std::vector<std::string>& variables) {
  std::string head;
  std::vector<std::string> quoted;
  switch (format) {
    case ResultFormat::kJson:
      for (const std::string& name : variables) {
        AppendJsonText(name, quoted.emplace_back());
      }
      return "{\"head\":{\"vars\":[" + Join(quoted, ",") + "]},\"results\":{\"bindings\":[";
    case ResultFormat::kXml:
      head = std::string(kXmlHead) + "<head>";
      for (const std::string& name : variables) head += "<variable name=\"" + name + "\"/>";
      return head + "</head>\n<results>\n";
    case ResultFormat::kCsv:
      return Join(variables, ",") + "\r\n";
    case ResultFormat::kTsv:
      for (const std::string& name : variables) quoted.push_back("?" + name);
      return Join(quoted, "\t") + "\n";
  }
  return head;
}

}  // namespace

std::string_view MediaType(ResultFormat format) {
  return kNames[static_cast<std::size_t>(format)].name;
}

std::optional<ResultFormat> ResultFormatOf(std::string_view name) {
  const std::string wanted = ToLower(Trim(name.substr(0, name.find(';'))));
  for (const FormatName& known : kNames) {
    if (known.name == wanted) return known.format;
  }
  return std::nullopt;
}

ResultWriter::ResultWriter(ResultFormat format, std::vector<std::string> variables, Write write)
    : format_(format), variables_(std::move(variables)), write_(std::move(write)) {
  text_ = Head(format_, variables_);
}

bool ResultWriter::Flush(std::size_t at_least) {
  if (is_open_ && text_.size() >= at_least && !text_.empty()) {
    is_open_ = write_(text_);
    text_.clear();
  }
  return is_open_;
}

bool ResultWriter::Row(Cells cells) {
  if (!is_open_) return false;
  switch (format_) {
    case ResultFormat::kJson:
      AppendJson(cells);
      break;
    case ResultFormat::kXml:
      AppendXml(cells);
      break;
    default:
      AppendSeparated(cells);
  }
  is_first_ = false;
  return Flush(kPiece);
}

void ResultWriter::AppendJson(Cells cells) {
  text_ += is_first_ ? "\n{" : ",\n{";
  bool is_first = true;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i]) continue;
    const TermView& term = *cells[i];
    if (!std::exchange(is_first, false)) text_ += ",";
    AppendJsonText(variables_[i], text_);
    text_ += term.kind == TermKind::kIri     ? ":{\"type\":\"uri\""
             : term.kind == TermKind::kBlank ? ":{\"type\":\"bnode\""
                                             : ":{\"type\":\"literal\"";
    if (!term.language.empty()) {
      text_ += ",\"xml:lang\":";
      AppendJsonText(term.language, text_);
    } else if (!term.datatype.empty()) {
      text_ += ",\"datatype\":";
      AppendJsonText(term.datatype, text_);
    }
    text_ += ",\"value\":";
    AppendJsonText(term.value, text_);
    text_ += "}";
  }
  text_ += "}";
}

void ResultWriter::AppendXml(Cells cells) {
  text_ += "<result>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i]) continue;
    const TermView& term = *cells[i];
    const std::string_view element = term.kind == TermKind::kIri     ? "uri"
                                     : term.kind == TermKind::kBlank ? "bnode"
                                                                     : "literal";
    text_ += "<binding name=\"" + variables_[i] + "\"><";
    text_ += element;
    const bool has_language = !term.language.empty();
    if (has_language || !term.datatype.empty()) {
      text_ += has_language ? " xml:lang=\"" : " datatype=\"";
      AppendXmlText(has_language ? term.language : term.datatype, text_);
      text_ += "\"";
    }
    text_ += ">";
    AppendXmlText(term.value, text_);
    text_ += "</";
    text_ += element;
    text_ += "></binding>";
  }
  text_ += "</result>\n";
}

void ResultWriter::AppendSeparated(Cells cells) {
  const bool is_csv = format_ == ResultFormat::kCsv;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text_ += is_csv ? "," : "\t";
    if (!cells[i]) continue;
    const TermView& term = *cells[i];
    if (!is_csv) {
      text_ += IsBareNumber(term) ? std::string(term.value) : rdf::ToNTriples(term);
    } else {
      AppendCsvText(
          term.kind == TermKind::kBlank ? "_:" + std::string(term.value) : std::string(term.value),
          text_);
    }
  }
  text_ += is_csv ? "\r\n" : "\n";
}

bool ResultWriter::End() {
  if (format_ == ResultFormat::kJson) text_ += "\n]}}\n";
  if (format_ == ResultFormat::kXml) text_ += "</results>\n</sparql>\n";
  return Flush(0);
}

std::string WriteBoolean(ResultFormat format, bool yes) {
  const std::string word = yes ? "true" : "false";
  switch (format) {
    case ResultFormat::kJson:
      return "{\"head\":{},\"boolean\":" + word + "}\n";
    case ResultFormat::kXml:
      return std::string(kXmlHead) + "<head/>\n<boolean>" + word + "</boolean>\n</sparql>\n";
    case ResultFormat::kCsv:
      return word + "\r\n";
    case ResultFormat::kTsv:
      break;
  }
  return word + "\n";
}

std::string WriteAnswer(ResultFormat format, const Answer& answer) {
  if (answer.form == Form::kAsk) return WriteBoolean(format, answer.yes);
  std::string text;
  ResultWriter writer(format, answer.variables, [&](std::string_view piece) {
    text += piece;
    return true;
  });
  for (const auto& row : answer.rows) {
    std::vector<std::optional<TermView>> cells;
    for (const auto& cell : row) {
      cells.push_back(cell ? std::optional(cell->view()) : std::nullopt);
    }
    writer.Row(cells);
  }
  writer.End();
  return text;
}

}  // namespace lares::sparql
