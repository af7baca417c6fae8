// Where things usually are: counts of (object class, place class), and Bayes over them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/aliases.h"

namespace lares::places {

// One row: `count` statements that `object` is found in `place`. IRIs canonical.
struct PriorRow {
  std::string object;
  std::string place;
  double count = 0;
  std::string source;  // of the row; may be empty
};

// A table with its name. Places are rooms and furniture alike; `where` ranks those of one kind.
struct PriorTable {
  std::string name;
  std::string title;
  std::vector<PriorRow> rows;  // distinct (object, place), in that order
};

enum class PriorFormat { kOmics, kTsv };

// kOmics: RDF of any format (RDF/XML as published), individuals of class OmicsLocations with
// `subject` (the object's class) and `object` (the place's), each counting one. kTsv: columns
// object, place, count, source (IRIs, prefixed names "lares:Cup" or bare local names of Lares'
// ontology; the source may be left out), '#' comments, of which "# title: …" gives the title, and
// an optional head "object place count source". Rows of one pair add up. Errors are kInvalid and
// carry the place in the file: counts that are absent, negative or not finite, an individual
// without subject or object, a table without rows or whose counts are all zero.
PriorTable ReadPrior(std::string_view bytes, PriorFormat format, const std::string& name,
                     const rdf::AliasTable& aliases);

struct RankedPlace {
  std::string place;
  double probability = 0;  // P(place | object); over all places of the table the sum is 1
  double support = 0;      // count(object, place)
};

// A table made ready for many questions. Immutable and thread-safe; keeps no reference to the
// table.
class PriorIndex {
 public:
  explicit PriorIndex(const PriorTable& table);

  // Eq. 4.1 and 4.2 of the thesis done as true Bayes: P(O | place) = (count + λ) / (N_place + λ·V)
  // with V the number of object classes of the table, P(place) = N_place / N from the counts.
  // Ranked, most probable first; ties by IRI. Empty when the table never mentions `object`. Throws
  // kInvalid for a λ that is negative or not finite.
  std::vector<RankedPlace> Rank(std::string_view object, double lambda = 0.5) const;

  std::size_t object_count() const { return objects_.size(); }
  const std::vector<std::string>& places() const { return places_; }

 private:
  struct Count {
    std::uint32_t place;  // index into places_
    double count;
  };
  std::vector<std::string> places_;   // sorted
  std::vector<double> place_totals_;  // N_place
  double total_ = 0;                  // N
  std::unordered_map<std::string, std::vector<Count>> objects_;
};

// PriorIndex(table).Rank(object, lambda): for a single question.
std::vector<RankedPlace> RankPlaces(const PriorTable& table, std::string_view object,
                                    double lambda = 0.5);

// The rows of the places that `keep` keeps, under the same name: rooms alone, or furniture alone.
PriorTable OnlyPlaces(const PriorTable& table,
                      const std::function<bool(std::string_view place)>& keep);

}  // namespace lares::places
