// What is part of what, and which wholes are places.
#pragma once

#include <optional>
#include <vector>

#include "mapping/semantic/names.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// What a thing belongs to.
struct Belonging {
  std::optional<rdf::TermId> whole;  // the nearest that it is a proper physical part of
  std::optional<rdf::TermId> room;   // the nearest room that it is in, or part of, whole by whole
  std::vector<rdf::TermId> maps;     // that describe it; else those of the nearest whole with any
};

// Chains of properPhysicalParts (and its inverse) are followed whether they are closed or not;
// those of more than 64 wholes as far as the nearest 64. `view` and `names` must outlive it.
class Parts {
 public:
  Parts(const rdf::View& view, const Names& names) : view_(view), names_(names) {}

  // Nearest first, each once, without the thing itself; circles end.
  std::vector<rdf::TermId> Wholes(rdf::TermId thing) const;
  Belonging BelongingOf(rdf::TermId thing) const;

  // Of a class that the lowest layer of the view puts under Place: other ontologies call containers
  // places too.
  bool IsPlace(rdf::TermId thing) const;
  bool Is(rdf::TermId thing, rdf::TermId kind) const {
    return view_.Contains({thing, names_.type, kind});
  }

 private:
  std::vector<rdf::TermId> DirectWholes(rdf::TermId thing) const;

  const rdf::View& view_;
  const Names& names_;
};

}  // namespace lares::semantic
