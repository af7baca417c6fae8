// `--recover`: the known faults of RDF/XML in the wild, each mended where it is unambiguous.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

struct RepairedXml {
  // Bytes [offset, offset + length) of the original became `size` bytes.
  struct Edit {
    std::size_t offset = 0;
    std::size_t length = 0;
    std::size_t size = 0;
  };
  struct Repair {
    Place place;             // in the original
    std::string fault;       // "malformed comment '<!-x-->'"
    std::string remedy;      // "read as a comment"
    bool breaks_xml = true;  // an XML parser stops there; else only RDF is violated
  };
  std::string text;
  std::vector<Edit> edits;      // by offset
  std::vector<Repair> repairs;  // by place
};

// Repairs malformed comments, references to undeclared entities whose name is a known prefix, and
// misplaced rdf:resource; leaves everything else to the parsers. Throws kInvalid, with its place,
// for a fault of these kinds that could be mended in more than one way.
RepairedXml RepairXml(std::string_view bytes, const ReadOptions& options);

// `error`, which a parser found in `bytes`, said in our words where it is a fault that RepairXml
// mends, with the hint to ask for that.
Error ExplainXmlError(const Error& error, std::string_view bytes, const ReadOptions& options);

// The place in `original` of a place in the repaired text.
Place OriginalPlace(const RepairedXml& repaired, std::string_view original, const Place& place);

}  // namespace lares::rdf
