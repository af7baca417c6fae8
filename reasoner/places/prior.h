// Where things usually are: counts of (object class, place class), and Bayes over them.
#pragma once

#include <map>
#include <string>
#include <string_view>
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
  std::vector<PriorRow> rows;  // distinct (object, place)
};

enum class PriorFormat { kOmics, kTsv };

// kOmics: RDF/XML, individuals of class OmicsLocations with `subject` and `object`; kTsv: columns
// object, place, count, source (IRIs, prefixed names "lares:Cup" or bare local names of Lares'
// ontology), '#' comments. Errors carry the place in the file; negative, NaN and absent counts,
// and tables without rows, are refused.
PriorTable ReadPrior(std::string_view bytes, PriorFormat format, const std::string& name,
                     const rdf::AliasTable& aliases);

struct RankedPlace {
  std::string place;
  double probability = 0;    // P(place | object); over all places of the table the sum is 1
  double support = 0;        // count(object, place)
};

// Eq. 4.1 and 4.2 of the thesis done as true Bayes: P(O | place) = (count + λ) / (N_place + λ·V)
// with V the number of object classes of the table and λ = 0.5, P(place) from the counts. Ranked,
// most probable first; ties by IRI. Empty when the table never mentions `object`.
std::vector<RankedPlace> RankPlaces(const PriorTable& table, std::string_view object,
                                    double lambda = 0.5);

}  // namespace lares::places
