#include "ontology/rdf/aliases.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::rdf {
namespace {

constexpr char kTable[] =
    "# alias\tcanonical\treason\n"
    "http://ias.cs.tum.edu/kb/knowrob.owl#\thttps://w3id.org/lares#\tKnowRob 1.x\n"
    "http://ias.cs.tum.edu/kb/\thttps://example.org/rest/\tlonger wins\n"
    "https://w3id.org/lares#Bed-PieceOfFurniture\thttps://w3id.org/lares#Bed\tplain name\n"
    "http://ias.cs.tum.edu/kb/knowrob.owl#Odd\thttps://w3id.org/lares#Even\texact wins\n";

TEST(AliasTableTest, NamespaceRowThenExactRow) {
  const AliasTable table = AliasTable::FromTsv(kTable, "t");
  EXPECT_EQ(table.Canonical("http://ias.cs.tum.edu/kb/knowrob.owl#Cup"),
            "https://w3id.org/lares#Cup");
  EXPECT_EQ(table.Canonical("http://ias.cs.tum.edu/kb/knowrob.owl#Bed-PieceOfFurniture"),
            "https://w3id.org/lares#Bed");
  EXPECT_EQ(table.Canonical("http://ias.cs.tum.edu/kb/x"), "https://example.org/rest/x");
}

TEST(AliasTableTest, ExactRowBeatsNamespaceRow) {
  EXPECT_EQ(AliasTable::FromTsv(kTable, "t").Canonical("http://ias.cs.tum.edu/kb/knowrob.owl#Odd"),
            "https://w3id.org/lares#Even");
}

TEST(AliasTableTest, UnknownIriIsItself) {
  EXPECT_EQ(AliasTable::FromTsv(kTable, "t").Canonical("http://a/b"), "http://a/b");
}

TEST(AliasTableTest, TwoMeaningsForOneAliasAreRefused) {
  EXPECT_THROW(AliasTable({{"http://a", "http://b", "r"}, {"http://a", "http://c", "r"}}), Error);
}

TEST(AliasTableTest, ChainsAreRefused) {
  EXPECT_THROW(AliasTable({{"http://a", "http://b", "r"}, {"http://b", "http://c", "r"}}), Error);
}

TEST(AliasTableTest, BadRowNamesItsLine) {
  try {
    AliasTable::FromTsv("# ok\nonly-one-cell\n", "aliases.tsv");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.FullMessage().rfind("aliases.tsv:2", 0), 0U);
  }
}

}  // namespace
}  // namespace lares::rdf
