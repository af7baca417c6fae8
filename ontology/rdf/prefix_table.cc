#include "ontology/rdf/prefix_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

bool IsAlpha(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsLocalByte(char c) {
  return IsAlpha(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

bool IsPrefixName(std::string_view name) {
  return name.empty() || (IsAlpha(name[0]) && name.back() != '.' &&
                          std::all_of(name.begin(), name.end(), IsLocalByte));
}

bool IsLocalName(std::string_view name) {
  return name.empty() || (name[0] != '-' && name[0] != '.' && name.back() != '.');
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWellKnown = {
    {{"rdf", kRdf}, {"rdfs", kRdfs}, {"owl", kOwl}, {"xsd", kXsd}}};

}  // namespace

PrefixTable::PrefixTable(const std::map<std::string, std::string>& prefixes) {
  for (const auto& [prefix, space] : prefixes) {
    if (!IsPrefixName(prefix) || !IsAbsoluteIri(space)) continue;
    declared_.emplace(prefix, space);
    of_namespace_.emplace(space, prefix);
  }
  for (const auto& [prefix, space] : kWellKnown) {
    if (declared_.count(prefix) != 0 || of_namespace_.count(space) != 0) continue;
    declared_.emplace(prefix, space);
    of_namespace_.emplace(space, prefix);
    unused_.emplace(prefix);
  }
}

std::string PrefixTable::Shorten(std::string_view iri) {
  for (std::size_t at = iri.size();; --at) {
    const auto row = of_namespace_.find(iri.substr(0, at));
    if (row != of_namespace_.end() && IsLocalName(iri.substr(at))) {
      if (const auto unused = unused_.find(row->second); unused != unused_.end()) {
        unused_.erase(unused);
      }
      return row->second + ":" + std::string(iri.substr(at));
    }
    if (at == 0 || !IsLocalByte(iri[at - 1])) return {};
  }
}

std::string PrefixTable::Declarations() const {
  std::string lines;
  for (const auto& [prefix, space] : Used()) {
    lines += "@prefix " + prefix + ": <" + space + "> .\n";
  }
  return lines;
}

std::vector<std::pair<std::string, std::string>> PrefixTable::Used() const {
  std::vector<std::pair<std::string, std::string>> used;
  for (const auto& row : declared_) {
    if (unused_.count(row.first) == 0) used.push_back(row);
  }
  return used;
}

}  // namespace lares::rdf
