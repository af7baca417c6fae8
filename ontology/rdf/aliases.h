// One notion, several historic names: the alias table.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace lares::rdf {

// `alias` (IRI, or a namespace ending in '#' or '/' when `is_namespace`) means `canonical`.
struct Alias {
  std::string alias;
  std::string canonical;
  std::string reason;
  bool is_namespace = false;
};

// Immutable after construction; thread-safe.
class AliasTable {
 public:
  AliasTable() = default;
  // Throws kInvalid when one alias has two canonical names, or a canonical name is itself an alias.
  explicit AliasTable(std::vector<Alias> aliases);
  // Rows "alias<TAB>canonical<TAB>reason"; lines that begin with '#' are comments. A row whose both
  // sides end in '#' or '/' maps a namespace: any IRI below it. Errors carry file and line.
  static AliasTable FromTsv(std::string_view text, const std::string& source);

  // The canonical IRI: an exact row wins; else the longest namespace row is applied, and then an
  // exact row for what came out; else `iri` itself.
  std::string Canonical(std::string_view iri) const;
  const std::vector<Alias>& aliases() const { return aliases_; }

 private:
  std::vector<Alias> aliases_;
  std::unordered_map<std::string, std::size_t> exact_;
  std::vector<std::size_t> namespaces_;  // longest alias first
};

}  // namespace lares::rdf
