// JSON-LD: any bytes are read or refused with a place; what is read can be written and read again,
// and says the same then.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

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

std::size_t CountDistinct(const Document& document) {
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> distinct;
  for (const Statement& s : document.statements) {
    distinct.emplace(s.subject, s.predicate, s.object, s.graph);
  }
  return distinct.size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto document = Read(bytes, Format::kJsonLd);
  if (!document) return 0;
  for (const Format format : {Format::kJsonLd, Format::kNQuads}) {
    const std::string text = WriteRdf(*document, format);
    const auto again = Read(text, format);
    if (!again) Fail("what was written cannot be read", text);
    if (CountDistinct(*again) != CountDistinct(*document)) Fail("statements changed", text);
  }
  return 0;
}
