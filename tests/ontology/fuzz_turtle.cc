// Turtle, TriG, N-Triples, N-Quads: any bytes are read or refused; what is read can be written and
// read again; and what is N-Triples is Turtle too.
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
  const std::string text = WriteRdf(document, format);
  const auto again = Read(text, format);
  if (!again) Fail("what was written cannot be read", text);
  if (again->statements.size() != document.statements.size()) Fail("statements were lost", text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::optional<Document> turtle;
  for (const Format format : {Format::kTurtle, Format::kTriG, Format::kNTriples, Format::kNQuads}) {
    const auto document = Read(bytes, format);
    if (format == Format::kTurtle) turtle = document;
    if (!document) continue;
    CheckRoundTrip(*document, format);
    if (format != Format::kNTriples) continue;
    if (!turtle || turtle->statements.size() != document->statements.size()) {
      Fail("N-Triples that is not Turtle", bytes);
    }
  }
  return 0;
}
