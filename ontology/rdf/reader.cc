#include "ontology/rdf/reader.h"

#include "base/text.h"
#include "ontology/rdf/byte_set.h"
#include "ontology/rdf/owl_syntax/owl_readers.h"
#include "ontology/rdf/parsers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"

namespace lares::rdf {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Where the longest well-formed beginning of `bytes` ends, give or take one character.
std::size_t EndOfUtf8(std::string_view bytes) {
  std::size_t good = 0;
  std::size_t bad = bytes.size();
  while (good < bad) {
    std::size_t middle = good + (bad - good + 1) / 2;
    // A cut inside a character is no fault.
    while (middle > good && middle < bytes.size() &&
           (static_cast<unsigned char>(bytes[middle]) & 0xC0) == 0x80) {
      --middle;
    }
    if (middle == good) break;
    if (IsUtf8(bytes.substr(good, middle - good))) {
      good = middle;
    } else if (bad == middle) {
      break;
    } else {
      bad = middle;
    }
  }
  return good;
}

void CheckText(std::string_view bytes, const std::string& source) {
  if (!IsAscii(bytes) && !IsUtf8(bytes)) {
    throw Error(Code::kInvalid, "a byte that is not UTF-8",
                PlaceAt(bytes, EndOfUtf8(bytes), source));
  }
}

}  // namespace

Document ReadRdf(std::string_view bytes, Format format, const ReadOptions& options) {
  if (bytes.size() > options.max_bytes) {
    throw Error(Code::kTooLarge,
                "the document has " + std::to_string(bytes.size()) + " bytes; at most " +
                    std::to_string(options.max_bytes) + " are read",
                {options.source, 0, 0});
  }
  if (!options.base_iri.empty() && !IsAbsoluteIri(options.base_iri)) {
    throw Error(Code::kInvalid, "the base IRI " + Quoted(options.base_iri) + " is not absolute");
  }
  if (format == Format::kRdfXml) return ReadRdfXml(bytes, options);
  if (format == Format::kOwlXml) return ReadOwlXml(bytes, options);
  CheckText(bytes, options.source);
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  if (format == Format::kOwlFunctional) return ReadOwlFunctional(bytes, options);
  if (format == Format::kJsonLd) return ReadJsonLd(bytes, options);
  return ReadWithSerd(bytes, format, options);
}

}  // namespace lares::rdf
