#include "server/knowledge/named_place.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::server {
namespace {

constexpr std::size_t kMaxPrefix = 64;  // of a name in Turtle
constexpr int kMaxPlaces = 1000;        // of one name that are looked at

// Whether what stands before `at` on its line is no more than a prefix: a Turtle document begins to
// describe something there.
bool BeginsLine(std::string_view bytes, std::size_t at) {
  const std::size_t from = at - std::min(at, kMaxPrefix);
  const std::string_view near = bytes.substr(from, at - from);
  const std::size_t newline = near.rfind('\n');
  if (newline == std::string_view::npos && from > 0) return false;
  const std::string_view before = near.substr(newline + 1);  // npos + 1 is 0
  return before.ends_with(':') && before.find_first_of(" \t<\"") == std::string_view::npos;
}

std::size_t FindDescribed(std::string_view bytes, const std::string& name) {
  const std::size_t first = bytes.find(name);
  std::size_t at = first;
  for (int i = 0; i < kMaxPlaces && at != std::string_view::npos; ++i) {
    if (BeginsLine(bytes, at)) return at;
    at = bytes.find(name, at + 1);
  }
  return first;
}

// An IRI stands there whole, with a usual prefix, or by its local name.
std::size_t FindNamed(std::string_view bytes, const std::string& iri) {
  std::vector<std::string> forms{iri};
  const std::string local(LocalName(iri));
  for (const auto& [prefix, space] : {std::pair("owl:", rdf::kOwl), std::pair("rdfs:", rdf::kRdfs),
                                      std::pair("rdf:", rdf::kRdf)}) {
    if (iri.starts_with(space)) forms.push_back(prefix + local);
  }
  forms.push_back(local);
  for (const std::string& form : forms) {
    const std::size_t found = form.empty() ? std::string::npos : FindDescribed(bytes, form);
    if (found != std::string::npos) return found;
  }
  return std::string::npos;
}

}  // namespace

Place PlaceOf(const std::string& sentence, std::string_view bytes, const std::string& source) {
  for (std::size_t at = 0; at < sentence.size(); ++at) {
    const char close = sentence[at] == '\'' ? '\'' : sentence[at] == '<' ? '>' : '\0';
    if (close == '\0') continue;
    const std::size_t end = sentence.find(close, at + 1);
    if (end == std::string::npos) break;
    const std::size_t found = FindNamed(bytes, sentence.substr(at + 1, end - at - 1));
    at = end;
    if (found == std::string_view::npos) continue;
    const std::string_view before = bytes.substr(0, found);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {source, static_cast<int>(line), static_cast<int>(found - line_start) + 1};
  }
  return {source, 0, 0};
}

}  // namespace lares::server
