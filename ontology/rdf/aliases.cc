#include "ontology/rdf/aliases.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace lares::rdf {
namespace {

bool IsNamespaceRow(const Alias& row) {
  const auto ends = [](std::string_view text) {
    return text.ends_with('#') || text.ends_with('/');
  };
  return ends(row.alias) && ends(row.canonical);
}

}  // namespace

AliasTable::AliasTable(std::vector<Alias> aliases) : aliases_(std::move(aliases)) {
  for (std::size_t i = 0; i < aliases_.size(); ++i) {
    Alias& row = aliases_[i];
    row.is_namespace = IsNamespaceRow(row);
    const auto [entry, is_new] = exact_.emplace(row.alias, i);
    if (!is_new && aliases_[entry->second].canonical != row.canonical) {
      throw Error(Code::kInvalid, "<" + row.alias + "> is an alias of two names: <" +
                                      aliases_[entry->second].canonical + "> and <" +
                                      row.canonical + ">");
    }
    if (row.is_namespace) namespaces_.push_back(i);
  }
  std::stable_sort(namespaces_.begin(), namespaces_.end(), [this](std::size_t a, std::size_t b) {
    return aliases_[a].alias.size() > aliases_[b].alias.size();
  });
  for (const Alias& row : aliases_) {
    if (Canonical(row.canonical) != row.canonical) {
      throw Error(Code::kInvalid, "the canonical name <" + row.canonical + "> is itself an alias");
    }
  }
}

AliasTable AliasTable::FromTsv(std::string_view text, const std::string& source) {
  std::vector<Alias> aliases;
  int line_number = 0;
  for (const std::string& line : Split(text, '\n')) {
    ++line_number;
    if (Trim(line).empty() || line[0] == '#') continue;
    std::vector<std::string> cells = Split(line, '\t');
    if (cells.size() != 3 || Trim(cells[0]).empty() || Trim(cells[1]).empty() ||
        Trim(cells[2]).empty()) {
      throw Error(Code::kInvalid, "an alias row is alias, canonical name and reason, tab-separated",
                  {source, line_number, 1});
    }
    aliases.push_back({std::string(Trim(cells[0])), std::string(Trim(cells[1])),
                       std::string(Trim(cells[2])), false});
  }
  return AliasTable(std::move(aliases));
}

std::string AliasTable::Canonical(std::string_view iri) const {
  if (const auto row = exact_.find(std::string(iri)); row != exact_.end()) {
    return aliases_[row->second].canonical;
  }
  for (const std::size_t index : namespaces_) {
    const Alias& row = aliases_[index];
    if (!iri.starts_with(row.alias)) continue;
    std::string renamed = row.canonical + std::string(iri.substr(row.alias.size()));
    const auto exact = exact_.find(renamed);
    return exact == exact_.end() ? renamed : aliases_[exact->second].canonical;
  }
  return std::string(iri);
}

}  // namespace lares::rdf
