// A thing of the knowledge, named for people and for programs.
#pragma once

#include <string>

namespace lares::recipes {

struct Resource {
  std::string iri;         // canonical
  std::string label;       // for people: rdfs:label, else the local name
  std::string as_written;  // the IRI as its document wrote it; equal to `iri` without an alias

  friend bool operator==(const Resource&, const Resource&) = default;
};

}  // namespace lares::recipes
