// The 14 queries of the Lehigh University Benchmark over the closure of LUBM(1).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "reasoner/sparql/query.h"
#include "tests/lares_data.h"
#include "tests/reasoner/lubm.h"

namespace lares::sparql {
namespace {

using testing::LubmAnswers;
using testing::LubmQuery;
using testing::ReadLubm;

TEST(LubmTest, AllFourteenAnswersAreTheReferenceAnswers) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const Dataset dataset{ReadLubm(lubm, dictionary), {}};
  for (int number = 1; number <= 14; ++number) {
    const Query query = Parse(LubmQuery(lubm, number));
    std::vector<std::string> found;
    const auto ask = [&] {
      found.clear();
      return Select(query, dataset, {}, {}, [&](Cells cells) {
        std::string line;
        for (const auto& cell : cells) {
          if (!line.empty()) line += ',';
          line += cell->value;
        }
        found.push_back(std::move(line));
        return true;
      });
    };
    ask();
    const Statistics warm = ask();
    std::sort(found.begin(), found.end());
    const auto wanted = LubmAnswers(lubm, number);
    EXPECT_EQ(found.size(), wanted.size()) << "query " << number;
    EXPECT_TRUE(found == wanted) << "query " << number;
    std::printf("q%-2d %6zu rows %8.2f ms\n", number, warm.rows,
                static_cast<double>(warm.elapsed.count()) / 1000);
  }
}

TEST(LubmTest, ALookupIsParsedPlannedAndAnsweredInOneGo) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const Dataset dataset{ReadLubm(lubm, dictionary), {}};
  const std::size_t terms = dictionary->size();
  const std::string text =
      "PREFIX ub: <http://www.lehigh.edu/~zhp2/2004/0401/univ-bench.owl#>\n"
      "SELECT ?name (STRLEN(?name) AS ?n) WHERE { "
      "<http://www.Department0.University0.edu/FullProfessor7> ub:name ?name }";
  const auto start = std::chrono::steady_clock::now();
  constexpr int kTimes = 1000;
  std::size_t rows = 0;
  for (int i = 0; i < kTimes; ++i) rows += Evaluate(Parse(text), dataset).rows.size();
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(rows, static_cast<std::size_t>(kTimes));
  EXPECT_EQ(dictionary->size(), terms) << "asking adds no terms to the dictionary";
  std::printf("a lookup: %.1f us\n", took.count() / kTimes);
}

}  // namespace
}  // namespace lares::sparql
