// OWL 2's mapping to RDF and back, construct by construct.
#include "tests/ontology/owl_mapping_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ontology/rdf/owl_syntax/constructs.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf::testing {
namespace {

using ::testing::HasSubstr;

Document Turtle(std::string_view statements) {
  return ReadRdf(TurtleText(statements), Format::kTurtle, Named("turtle"));
}

void ExpectSame(const Document& expected, const Document& got, std::string_view what) {
  EXPECT_TRUE(AreIsomorphic(expected, got)) << what << "\nexpected:\n"
                                            << Lines(expected) << "got:\n"
                                            << Lines(got);
}

class OwlMapping : public ::testing::TestWithParam<MappingRow> {};

TEST_P(OwlMapping, FunctionalSyntaxIsReadAsItsTriples) {
  const MappingRow& row = GetParam();
  ExpectSame(Turtle(row.turtle),
             ReadRdf(FunctionalText(row.functional), Format::kOwlFunctional, Named("functional")),
             row.functional);
}

TEST_P(OwlMapping, OwlXmlIsReadAsTheSameTriples) {
  const MappingRow& row = GetParam();
  ExpectSame(Turtle(row.turtle), ReadRdf(OwlXmlText(row.xml), Format::kOwlXml, Named("xml")),
             row.xml);
}

TEST_P(OwlMapping, TriplesAreWrittenSoThatTheyReadTheSame) {
  const MappingRow& row = GetParam();
  const Document document = Turtle(std::string(row.turtle) + " " + std::string(row.declarations));
  for (const Format format : {Format::kOwlFunctional, Format::kOwlXml}) {
    const std::string text = WriteRdf(document, format);
    ExpectSame(document, ReadRdf(text, format, Named("written")), text);
  }
}

// Not another construct that happens to have the same triples.
TEST_P(OwlMapping, TriplesAreWrittenAsTheConstructTheyCameFrom) {
  const MappingRow& row = GetParam();
  if (row.name == "PlainLiteral" || row.name == "ObjectPropertyAssertionOfAnInverse") return;
  Document document = Turtle(std::string(row.turtle) + " " + std::string(row.declarations));
  const std::string text = WriteRdf(document, Format::kOwlFunctional);
  std::string_view rest = row.functional;
  while (!rest.empty()) {
    const std::size_t open = rest.find('(');
    if (open == std::string_view::npos) break;
    std::size_t begin = open;
    while (begin > 0 && std::isalpha(static_cast<unsigned char>(rest[begin - 1])) != 0) --begin;
    if (begin < open) {
      EXPECT_THAT(text, HasSubstr(std::string(rest.substr(begin, open - begin + 1))));
    }
    rest.remove_prefix(open + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, OwlMapping, ::testing::ValuesIn(MappingTable()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(OwlMappingTable, NamesEveryConstruct) {
  std::string all;
  for (const MappingRow& row : MappingTable()) all += std::string(row.functional) + " ";
  for (int i = 0; i < static_cast<int>(Construct::kNone); ++i) {
    const ConstructInfo& info = InfoOf(static_cast<Construct>(i));
    if (info.category == Category::kGroup || info.category == Category::kFacet) continue;
    EXPECT_THAT(all, HasSubstr(std::string(info.name) + "("));
  }
}

}  // namespace
}  // namespace lares::rdf::testing
