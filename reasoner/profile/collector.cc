#include "reasoner/profile/collector.h"

#include <algorithm>
#include <tuple>

#include "base/text.h"
#include "ontology/rdf/position.h"

namespace lares::profile {
namespace {

constexpr std::size_t kMostPlaces = 3;
constexpr std::size_t kMostNames = 5;
constexpr std::size_t kFarthestBack = 1 << 16;  // bytes that are searched before a statement's end

bool IsNameByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || static_cast<unsigned char>(c) >= 0x80;
}

bool IsWhole(std::string_view text, std::size_t at, std::size_t length) {
  return (at == 0 || !IsNameByte(text[at - 1])) &&
         (at + length >= text.size() || !IsNameByte(text[at + length]));
}

// Last whole `name` that begins before `end`, and not far before; npos.
std::size_t FindBefore(std::string_view text, std::string_view name, std::size_t end) {
  const std::size_t begin = end > kFarthestBack ? end - kFarthestBack : 0;
  const std::string_view window = text.substr(begin, end - begin);
  for (std::size_t at = window.rfind(name); at != std::string_view::npos;
       at = at == 0 ? std::string_view::npos : window.rfind(name, at - 1)) {
    if (IsWhole(text, begin + at, name.size())) return begin + at;
  }
  return std::string_view::npos;
}

std::size_t FindFrom(std::string_view text, std::string_view name, std::size_t begin) {
  for (std::size_t at = text.find(name, begin); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    if (IsWhole(text, at, name.size())) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::string_view ToString(Kind kind) {
  switch (kind) {
    case Kind::kProfile:
      return "profile";
    case Kind::kStructure:
      return "structure";
    case Kind::kUndeclared:
      return "undeclared";
    case Kind::kUnsatisfiable:
      return "unsatisfiable";
    case Kind::kContradiction:
      return "contradiction";
    case Kind::kRemark:
      return "remark";
  }
  return "remark";
}

Collector::Collector(const DocumentIndex& index, std::string_view text, std::string source)
    : index_(index), text_(text), source_(std::move(source)) {
  line_starts_.push_back(0);
  for (std::size_t at = text.find('\n'); at != std::string_view::npos;
       at = text.find('\n', at + 1)) {
    line_starts_.push_back(at + 1);
  }
  mentions_.assign(index.document().terms.size(), kNone);
  const auto& statements = index.document().statements;
  for (std::uint32_t i = 0; i < statements.size(); ++i) {
    const rdf::Statement& s = statements[i];
    for (const std::uint32_t term : {s.subject, s.predicate, s.object}) {
      if (mentions_[term] == kNone) mentions_[term] = i;
    }
  }
}

std::string Collector::NameOf(std::uint32_t term) const {
  if (index_.IsBlank(term)) return "something unnamed";
  if (index_.IsLiteral(term)) return "\"" + index_.Term(term).value.substr(0, 40) + "\"";
  if (!index_.Word(term).empty()) return std::string(index_.Word(term));
  const std::string_view local = LocalName(index_.Term(term).value);
  return local.empty() ? "<" + index_.Term(term).value + ">" : std::string(local);
}

// Readers know lines at best; the column is that of the term's name as the text spells it.
Place Collector::PlaceOf(std::uint32_t statement, std::uint32_t term) const {
  std::size_t line = 0;
  const auto& lines = index_.document().lines;
  if (statement < lines.size()) line = std::min<std::size_t>(lines[statement], line_starts_.size());
  std::string_view name = index_.Term(term).value;
  if (index_.IsIri(term) && !LocalName(name).empty()) name = LocalName(name);
  if (index_.IsBlank(term)) name = {};
  const std::size_t end =
      line > 0 && line < line_starts_.size() ? line_starts_[line] : text_.size();
  std::size_t at = std::string_view::npos;
  if (!name.empty()) {
    if (line > 0) at = FindBefore(text_, name, end);
    if (at == std::string_view::npos) at = FindFrom(text_, name, line > 0 ? end : 0);
  }
  if (at != std::string_view::npos) return PlaceOfOffset(at);
  if (line == 0) return {source_, 0, 0};
  const std::size_t start = text_.find_first_not_of(" \t", line_starts_[line - 1]);
  return PlaceOfOffset(start == std::string_view::npos ? line_starts_[line - 1] : start);
}

Place Collector::PlaceOfOffset(std::size_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const std::size_t line = static_cast<std::size_t>(next - line_starts_.begin());
  const std::size_t start = line_starts_[line - 1];
  const Place in_line = rdf::PlaceAt(text_.substr(start), offset - start, source_);
  return {source_, static_cast<int>(line), in_line.column};
}

void Collector::Add(Kind kind, const std::string& message, std::uint32_t statement,
                    std::uint32_t term, const std::string& name) {
  const auto [entry, is_new] = groups_.try_emplace({kind, message});
  Group& group = entry->second;
  Finding& finding = group.finding;
  if (is_new) {
    finding.kind = kind;
    finding.message = message;
    finding.count = 0;
  }
  ++finding.count;
  if (finding.names.size() < kMostNames) {
    const std::string called = name.empty() ? NameOf(term) : name;
    if (group.seen_names.emplace(called, true).second) finding.names.push_back(called);
  }
  if (finding.places.size() < kMostPlaces) {
    finding.places.push_back(PlaceOf(statement == kNone ? FirstMention(term) : statement, term));
  }
}

Report Collector::Take() {
  Report report;
  for (auto& [key, group] : groups_) {
    Finding& finding = group.finding;
    std::sort(finding.places.begin(), finding.places.end(), [](const Place& a, const Place& b) {
      return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    const bool is_remark = finding.kind == Kind::kRemark;
    report.is_clean = report.is_clean && is_remark;
    if (finding.kind == Kind::kProfile || finding.kind == Kind::kStructure) {
      report.is_owl2_rl = false;
    }
    report.findings.push_back(std::move(finding));
  }
  groups_.clear();
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [](const Finding& a, const Finding& b) {
                     const bool a_last = a.kind == Kind::kRemark;
                     const bool b_last = b.kind == Kind::kRemark;
                     return std::tie(a_last, a.places[0].line, a.places[0].column) <
                            std::tie(b_last, b.places[0].line, b.places[0].column);
                   });
  return report;
}

}  // namespace lares::profile
