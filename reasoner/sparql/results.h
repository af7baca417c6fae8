// Answers as text: SPARQL 1.1 Query Results JSON, XML, CSV and TSV (W3C Recommendations 2013).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoner/sparql/query.h"

namespace lares::sparql {

enum class ResultFormat { kJson, kXml, kCsv, kTsv };

// "application/sparql-results+json", …
std::string_view MediaType(ResultFormat format);
// From a media type (with or without parameters) or a short name ("json", "csv"); nothing for
// another.
std::optional<ResultFormat> ResultFormatOf(std::string_view name);

// A table as it comes: the head when constructed, Row for each solution, End once. `write` gets the
// text in pieces of a few kilobytes; when it returns false nothing more is written and Row returns
// false. Blank nodes keep their labels. CSV loses types, as its definition says.
class ResultWriter {
 public:
  using Write = std::function<bool(std::string_view)>;

  ResultWriter(ResultFormat format, std::vector<std::string> variables, Write write);
  bool Row(Cells cells);
  bool End();

 private:
  void AppendJson(Cells cells);
  void AppendXml(Cells cells);
  void AppendSeparated(Cells cells);
  bool Flush(std::size_t at_least);

  ResultFormat format_;
  std::vector<std::string> variables_;
  Write write_;
  std::string text_;
  bool is_first_ = true;
  bool is_open_ = true;
};

// The answer of ASK. CSV and TSV have no form for it in the standard: "true" or "false" and a line
// end.
std::string WriteBoolean(ResultFormat format, bool yes);
// All of an answer of SELECT or ASK.
std::string WriteAnswer(ResultFormat format, const Answer& answer);

}  // namespace lares::sparql
