#include "reasoner/places/prior.h"

#include "base/error.h"
#include "base/text.h"
#include "reasoner/places/read_prior.h"

namespace lares::places {

void TableBuilder::Add(const std::string& object, const std::string& place, double count,
                       const std::string& source_of_row) {
  Cell& cell = cells_[{object, place}];
  cell.count += count;
  if (!source_of_row.empty()) cell.sources.insert(source_of_row);
}

PriorTable TableBuilder::Finish(const std::string& name, const std::string& title, int line) const {
  PriorTable table{name, title, {}};
  double total = 0;
  for (const auto& [pair, cell] : cells_) {
    const std::vector<std::string> sources(cell.sources.begin(), cell.sources.end());
    table.rows.push_back({pair.first, pair.second, cell.count, Join(sources, "; ")});
    total += cell.count;
  }
  if (table.rows.empty()) throw Error(Code::kInvalid, "the table has no rows", {source_, line});
  if (!(total > 0)) {
    throw Error(Code::kInvalid, "all counts of the table are zero", {source_, line});
  }
  return table;
}

PriorTable ReadPrior(std::string_view bytes, PriorFormat format, const std::string& name,
                     const rdf::AliasTable& aliases) {
  switch (format) {
    case PriorFormat::kOmics:
      return ReadOmics(bytes, name, aliases);
    case PriorFormat::kTsv:
      return ReadTsv(bytes, name, aliases);
  }
  throw Error(Code::kInternal, "a prior format that is none");
}

}  // namespace lares::places
