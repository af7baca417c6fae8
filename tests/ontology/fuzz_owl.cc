// OWL functional syntax and OWL/XML: any bytes are read or refused, a fault has a place, and the
// axioms that were read can be written and read again in both syntaxes.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"

namespace {

using namespace lares::rdf;

[[noreturn]] void Fail(const char* what, std::string_view text) {
  std::fprintf(stderr, "%s\n%.*s\n", what, static_cast<int>(text.size()), text.data());
  std::abort();
}

std::optional<Document> Read(std::string_view bytes, Format format) {
  ReadOptions options;
  options.source = "fuzz";
  options.base_iri = "http://base/";
  try {
    return ReadRdf(bytes, format, options);
  } catch (const lares::Error& error) {
    if (!error.place()) Fail("a fault without a place", error.what());
    return std::nullopt;
  }
}

void CheckRoundTrip(const Document& document, Format format) {
  std::string text;
  try {
    text = WriteAxioms(document, format).text;
  } catch (const lares::Error&) {
    return;  // XML cannot hold every character
  }
  if (!Read(text, format)) Fail("what was written cannot be read", text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // Turtle too: any graph goes through the reverse mapping.
  for (const Format format : {Format::kOwlFunctional, Format::kOwlXml, Format::kTurtle}) {
    const auto document = Read(bytes, format);
    if (!document) continue;
    CheckRoundTrip(*document, Format::kOwlFunctional);
    CheckRoundTrip(*document, Format::kOwlXml);
  }
  return 0;
}
