// Any bytes are a query or refused with a place; a query can be planned and asked of a small world
// within its limits.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "reasoner/sparql/results.h"
#include "tests/reasoner/sparql/sparql_support.h"

namespace {

using namespace lares::sparql;

void CheckAnswer(const Query& query) {
  static const testing::World world(
      ":a :p 1, 2.5, \"x\"@en ; :q :b . :b :q :a ; :p \"2020-01-01T00:00:00Z\", [ :p true ] .");
  const Dataset dataset = DatasetOf(world.view, DocumentGraphIri);
  const Limits limits{std::chrono::milliseconds(50), 10'000, 4u << 20};
  try {
    const Answer answer = Evaluate(query, dataset, limits);
    for (const auto format :
         {ResultFormat::kJson, ResultFormat::kXml, ResultFormat::kCsv, ResultFormat::kTsv}) {
      WriteAnswer(format, answer);
    }
    Explain(query, dataset, ExplainFormat::kJson);
  } catch (const lares::Error& error) {
    if (error.code() != lares::Code::kInternal) return;
    std::fprintf(stderr, "a broken invariant: %s\n", error.what());
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ParseOptions options;
  options.base_iri = "http://example.org/";
  options.prefixes = {{"", "http://example.org/"}};
  std::optional<Query> query;
  try {
    query = Parse(text, options);
  } catch (const lares::Error& error) {
    const bool may_lack_place = error.code() == lares::Code::kTooLarge;
    if (error.place() || may_lack_place) return 0;
    std::fprintf(stderr, "a fault without a place: %s\n", error.what());
    std::abort();
  }
  CheckAnswer(*query);
  return 0;
}
