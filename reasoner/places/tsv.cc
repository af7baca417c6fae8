#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/places/read_prior.h"

namespace lares::places {
namespace {

constexpr double kMaxCount = 1e12;

class TsvReader {
 public:
  TsvReader(const std::string& name, const rdf::AliasTable& aliases)
      : name_(name), aliases_(aliases), table_(name) {}

  void ReadLine(std::string_view line) {
    ++line_;
    if (Trim(line).empty()) return;
    if (line[0] == '#') return ReadComment(Trim(line.substr(1)));
    const std::vector<std::string> cells = Split(line, '\t');
    if (cells.size() < 3 || cells.size() > 4) {
      Fail("a row is object, place, count and source, tab-separated");
    }
    const bool is_first_row = !std::exchange(has_rows_, true);
    if (is_first_row && Trim(cells[0]) == "object" && Trim(cells[2]) == "count") return;
    table_.Add(ToIri(cells[0], "object"), ToIri(cells[1], "place"), ToCount(cells[2]),
               cells.size() == 4 ? std::string(Trim(cells[3])) : "");
  }

  PriorTable Finish() const { return table_.Finish(name_, title_, line_); }

 private:
  void ReadComment(std::string_view comment) {
    constexpr std::string_view kTitle = "title:";
    if (title_.empty() && ToLower(comment.substr(0, kTitle.size())) == kTitle) {
      title_ = Trim(comment.substr(kTitle.size()));
    }
  }

  std::string ToIri(std::string_view cell, const char* column) const {
    const std::string_view text = Trim(cell);
    constexpr std::string_view kPrefix = "lares:";
    if (text.starts_with(kPrefix) && IsLocal(text.substr(kPrefix.size()))) {
      return aliases_.Canonical(std::string(rdf::kLares).append(text.substr(kPrefix.size())));
    }
    if (IsLocal(text)) return aliases_.Canonical(std::string(rdf::kLares).append(text));
    const bool is_iri = text.find("://") != std::string_view::npos &&
                        text.find_first_of(" <>\"{}|\\^`") == std::string_view::npos;
    if (!is_iri) {
      Fail("the " + std::string(column) + " '" + std::string(text.substr(0, 80)) +
           "' is no IRI, no lares: name and no bare name");
    }
    return aliases_.Canonical(text);
  }

  static bool IsLocal(std::string_view text) { return IsIdentifier(text); }

  double ToCount(std::string_view cell) const {
    const std::optional<double> count = ToNumber(Trim(cell));
    if (!count) Fail("the count '" + std::string(Trim(cell).substr(0, 40)) + "' is no number");
    if (!std::isfinite(*count) || *count < 0 || *count > kMaxCount) {
      Fail("a count is between 0 and 1e12, not " + std::string(Trim(cell).substr(0, 40)));
    }
    return *count;
  }

  [[noreturn]] void Fail(const std::string& message) const {
    throw Error(Code::kInvalid, message, {name_, line_});
  }

  const std::string& name_;
  const rdf::AliasTable& aliases_;
  TableBuilder table_;
  std::string title_;
  int line_ = 0;
  bool has_rows_ = false;
};

}  // namespace

PriorTable ReadTsv(std::string_view bytes, const std::string& name,
                   const rdf::AliasTable& aliases) {
  if (!IsUtf8(bytes)) throw Error(Code::kInvalid, "the table is not UTF-8 text", {name});
  TsvReader reader(name, aliases);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    reader.ReadLine(bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  return reader.Finish();
}

}  // namespace lares::places
