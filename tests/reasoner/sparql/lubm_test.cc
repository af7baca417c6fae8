// The 14 queries of the Lehigh University Benchmark over the closure of LUBM(1).
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <sstream>

#include "base/file.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/sparql/query.h"
#include "tests/lares_data.h"

namespace lares::sparql {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

std::string ReadGzip(const fs::path& path) {
  std::string text;
  std::array<char, 1 << 16> buffer{};
  gzFile file = gzopen(path.c_str(), "rb");
  for (int n = 0; (n = gzread(file, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  gzclose(file);
  return text;
}

rdf::View Closure(const fs::path& lubm, const std::shared_ptr<rdf::Dictionary>& dictionary) {
  rdf::ReadOptions options;
  options.base_iri = "http://example.org/univ-bench";
  const auto ontology =
      rdf::ReadRdf(ReadFile(lubm / "ontology/univ-bench.ttl"), rdf::Format::kTurtle, options);
  const auto data = rdf::ReadRdf(ReadGzip(lubm / "lubm-1-0-0.nt.gz"), rdf::Format::kNTriples, {});
  rdf::View view(dictionary);
  view = view.With(owl::Materialise(view, {rdf::MakeGraph(ontology, "ontology", {}, *dictionary)}));
  return view.With(owl::Materialise(view, {rdf::MakeGraph(data, "data", {}, *dictionary)}));
}

// The rows of a reference answer as sorted lines, the head apart; no rows for "NO ANSWERS.".
Lines Reference(const fs::path& file) {
  Lines lines;
  std::istringstream text(ReadFile(file));
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    if (!Trim(line).empty()) lines.emplace_back(Trim(line));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(LubmTest, AllFourteenAnswersAreTheReferenceAnswers) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const Dataset dataset{Closure(lubm, dictionary), {}};
  for (int number = 1; number <= 14; ++number) {
    const std::string name = std::to_string(number);
    const Query query = Parse(ReadFile(lubm / "queries" / ("q" + name + ".rq")));
    Lines found;
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
    const Lines wanted = Reference(lubm / "answers" / ("answers_query" + name + ".csv"));
    EXPECT_EQ(found.size(), wanted.size()) << "query " << name;
    EXPECT_TRUE(found == wanted) << "query " << name;
    std::printf("q%-2d %6zu rows %8.2f ms\n", number, warm.rows,
                static_cast<double>(warm.elapsed.count()) / 1000);
  }
}

TEST(LubmTest, ALookupIsParsedPlannedAndAnsweredInOneGo) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const Dataset dataset{Closure(lubm, dictionary), {}};
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
