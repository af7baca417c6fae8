// What the two readers of priors share.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "ontology/rdf/aliases.h"
#include "reasoner/places/prior.h"

namespace lares::places {

// Adds up rows of one pair; their sources are joined with "; ".
class TableBuilder {
 public:
  explicit TableBuilder(std::string source) : source_(std::move(source)) {}

  void Add(const std::string& object, const std::string& place, double count,
           const std::string& source_of_row);
  // Throws kInvalid, naming `line`, when there are no rows or nothing was counted.
  PriorTable Finish(const std::string& name, const std::string& title, int line) const;

 private:
  struct Cell {
    double count = 0;
    std::set<std::string> sources;
  };
  std::string source_;
  std::map<std::pair<std::string, std::string>, Cell> cells_;
};

PriorTable ReadOmics(std::string_view bytes, const std::string& name,
                     const rdf::AliasTable& aliases);
PriorTable ReadTsv(std::string_view bytes, const std::string& name, const rdf::AliasTable& aliases);

}  // namespace lares::places
