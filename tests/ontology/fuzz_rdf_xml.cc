// RDF/XML: any bytes are read or refused, and what is read can be written.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lares::rdf;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  ReadOptions options;
  options.source = "fuzz";
  options.base_iri = "http://base/";
  for (const bool recover : {false, true}) {
    options.recover = recover;
    Document document;
    try {
      document = ReadRdf(bytes, Format::kRdfXml, options);
    } catch (const lares::Error&) {
      continue;
    }
    const std::string text = WriteRdf(document, Format::kTurtle);
    if (ReadRdf(text, Format::kTurtle, options).statements.size() == document.statements.size()) {
      continue;
    }
    std::fprintf(stderr, "statements were lost in\n%s\n", text.c_str());
    std::abort();
  }
  return 0;
}
