#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "reasoner/places/prior.h"
#include "tests/lares_data.h"

namespace lares::places {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kLares[] = "https://w3id.org/lares#";

rdf::AliasTable Aliases() {
  return rdf::AliasTable::FromTsv(ReadFile(FindShared("ontology/aliases.tsv")), "aliases.tsv");
}

PriorTable Read(PriorFormat format, const std::string& bytes) {
  return ReadPrior(bytes, format, "table", Aliases());
}

std::string Refused(PriorFormat format, const std::string& bytes) {
  try {
    Read(format, bytes);
  } catch (const Error& error) {
    return error.code() == Code::kInvalid ? error.FullMessage() : "not kInvalid";
  }
  return "";
}

std::string RefusedTsv(const std::string& bytes) { return Refused(PriorFormat::kTsv, bytes); }

TEST(TsvPriorTest, ColumnsNamesAndCommentsAreRead) {
  const PriorTable table = Read(PriorFormat::kTsv,
                                "# title: Things at home\n"
                                "object\tplace\tcount\tsource\n"
                                "Cup\tlares:Kitchen\t3\tcounted\r\n"
                                "\n"
                                "# a comment\n"
                                "http://example.org/x#Pan\tOfficeRoom\t0.5\n");
  EXPECT_EQ(table.name, "table");
  EXPECT_EQ(table.title, "Things at home");
  ASSERT_THAT(table.rows, SizeIs(2));
  EXPECT_EQ(table.rows[0].object, "http://example.org/x#Pan");
  EXPECT_EQ(table.rows[0].place, std::string(kLares) + "Office");
  EXPECT_EQ(table.rows[0].count, 0.5);
  EXPECT_EQ(table.rows[1].object, std::string(kLares) + "Cup");
  EXPECT_EQ(table.rows[1].source, "counted");
}

TEST(TsvPriorTest, RowsOfOnePairAddUp) {
  const PriorTable table =
      Read(PriorFormat::kTsv, "Cup\tOffice\t1\tme\nCup\tOfficeRoom\t2\tyou\nCup\tOffice\t4\tme\n");
  ASSERT_THAT(table.rows, SizeIs(1));
  EXPECT_EQ(table.rows[0].count, 7);
  EXPECT_EQ(table.rows[0].source, "me; you");
}

TEST(TsvPriorTest, WrongRowsNameTheirLine) {
  const std::string good = "Cup\tKitchen\t1\n";
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\n"), HasSubstr("table:2: a row is object, place"));
  EXPECT_THAT(RefusedTsv(good + "Cup Kitchen 1\n"), HasSubstr("table:2: a row is"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\t1\ts\tmore\n"), HasSubstr("table:2: a row is"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\t-1\n"), HasSubstr("table:2: a count is between"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\tNaN\n"), HasSubstr("table:2: a count is between"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\tinf\n"), HasSubstr("table:2: a count is between"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\t1e300\n"), HasSubstr("table:2: a count is between"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\tmany\n"), HasSubstr("table:2: the count 'many'"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tKitchen\t\tme\n"), HasSubstr("table:2: the count ''"));
  EXPECT_THAT(RefusedTsv(good + "\tKitchen\t1\n"), HasSubstr("table:2: the object ''"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tthe kitchen\t1\n"), HasSubstr("table:2: the place"));
  EXPECT_THAT(RefusedTsv(good + "Cup\tother:Kitchen\t1\n"), HasSubstr("table:2: the place"));
}

TEST(TsvPriorTest, TablesThatCountNothingAreRefused) {
  EXPECT_THAT(RefusedTsv("Cup\tKitchen\t0\nPan\tKitchen\t0\n"),
              HasSubstr("table:2: all counts of the table are zero"));
  EXPECT_THAT(RefusedTsv("# only a comment\n"), HasSubstr("the table has no rows"));
  EXPECT_THAT(RefusedTsv("object\tplace\tcount\tsource\n"), HasSubstr("the table has no rows"));
  EXPECT_THAT(RefusedTsv(""), HasSubstr("the table has no rows"));
  EXPECT_THAT(RefusedTsv("C\xFFp\tKitchen\t1\n"), HasSubstr("not UTF-8"));
}

TEST(TsvPriorTest, OwnTableRanksRoomsAndFurnitureApart) {
  const PriorTable table =
      Read(PriorFormat::kTsv, ReadFile(FindShared("ontology/priors/lares.tsv")));
  EXPECT_FALSE(table.title.empty());
  const auto is_room = [](std::string_view place) {
    return place == std::string(kLares) + "Kitchen" || place == std::string(kLares) + "Bathroom";
  };
  const auto ranked = RankPlaces(OnlyPlaces(table, is_room), std::string(kLares) + "Cup");
  ASSERT_THAT(ranked, SizeIs(2));
  EXPECT_EQ(ranked[0].place, std::string(kLares) + "Kitchen");
  for (const PriorRow& row : table.rows) EXPECT_FALSE(row.source.empty()) << row.object;
}

std::string Omics(const std::string& individuals) {
  return "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
         "xmlns:k='http://knowrob.org/kb/knowrob.owl#'>\n" +
         individuals + "</rdf:RDF>\n";
}

std::string Individual(const std::string& name, const std::string& subject,
                       const std::string& object) {
  const std::string k = "http://knowrob.org/kb/knowrob.owl#";
  std::string text = "<k:OmicsLocations rdf:about='" + k + name + "'>\n";
  if (!subject.empty()) text += "<k:subject rdf:resource='" + k + subject + "'/>\n";
  if (!object.empty()) text += "<k:object rdf:resource='" + k + object + "'/>\n";
  return text + "</k:OmicsLocations>\n";
}

TEST(OmicsPriorTest, EachIndividualCountsOne) {
  const PriorTable table = Read(PriorFormat::kOmics, Omics(Individual("O-1", "Cup", "OfficeRoom") +
                                                           Individual("O-2", "Cup", "OfficeRoom") +
                                                           Individual("O-3", "Cup", "Kitchen")));
  ASSERT_THAT(table.rows, SizeIs(2));
  EXPECT_EQ(table.rows[0].place, std::string(kLares) + "Kitchen");
  EXPECT_EQ(table.rows[0].count, 1);
  EXPECT_EQ(table.rows[1].place, std::string(kLares) + "Office");
  EXPECT_EQ(table.rows[1].count, 2);
}

TEST(OmicsPriorTest, IncompleteIndividualsAreNamedWithTheirLine) {
  const auto refused = [](const std::string& individual) {
    return Refused(PriorFormat::kOmics, Omics(Individual("O-20", "Cup", "Kitchen") + individual));
  };
  EXPECT_THAT(refused(Individual("O-2", "", "Kitchen")),
              HasSubstr("table:6: <http://knowrob.org/kb/knowrob.owl#O-2> has no subject"));
  EXPECT_THAT(refused(Individual("O-2", "Cup", "")), HasSubstr("has no object"));
  EXPECT_THAT(refused(Individual("O-2", "Cup", "Kitchen") + Individual("O-2", "Cup", "Hall")),
              HasSubstr("has two values for"));
  EXPECT_THAT(refused("<k:OmicsLocations rdf:about='http://a/b'><k:subject>Cup</k:subject>"
                      "<k:object>Kitchen</k:object></k:OmicsLocations>"),
              HasSubstr("subject is no IRI"));
}

TEST(OmicsPriorTest, WhatIsNoOmicsIsRefused) {
  EXPECT_THAT(Refused(PriorFormat::kOmics, Omics("")), HasSubstr("no rows"));
  EXPECT_THAT(Refused(PriorFormat::kOmics, "<rdf:RDF"), HasSubstr("table:1"));
}

TEST(OmicsPriorTest, PublishedStatementsGiveThePublishedRooms) {
  LARES_REQUIRE_DATA(file, "priors/omics/locations.rdf");
  const PriorTable table = Read(PriorFormat::kOmics, ReadFile(file));
  EXPECT_THAT(table.rows, SizeIs(324));
  double statements = 0;
  for (const PriorRow& row : table.rows) statements += row.count;
  EXPECT_EQ(statements, 460);
  const PriorIndex index(table);
  EXPECT_EQ(index.object_count(), 271U);
  EXPECT_THAT(index.places(), SizeIs(10));

  const auto ranked = index.Rank(std::string(kLares) + "Cup");
  ASSERT_THAT(ranked, SizeIs(10));
  const std::vector<std::pair<std::string, double>> expected = {{"Kitchen", .7283},
                                                                {"Office", .1608},
                                                                {"Restaurant", .0393},
                                                                {"Hallway", .0213},
                                                                {"HospitalRoom", .0101}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(ranked[i].place, kLares + expected[i].first);
    EXPECT_NEAR(ranked[i].probability, expected[i].second, 5e-5) << expected[i].first;
  }
}

TEST(OmicsPriorTest, PublishedStatementsAndPublishedCountsAgree) {
  LARES_REQUIRE_DATA(rdf_file, "priors/omics/locations.rdf");
  LARES_REQUIRE_DATA(csv_file, "priors/omics/omics_object_room_counts.csv");
  std::map<std::pair<std::string, std::string>, double> from_counts;
  const rdf::AliasTable aliases = Aliases();
  for (const std::string& line : Split(ReadFile(csv_file), '\n')) {
    const std::vector<std::string> cells = Split(Trim(line), ',');
    if (cells.size() != 3 || cells[0] == "object") continue;
    const std::string space = "http://knowrob.org/kb/knowrob.owl#";
    from_counts[{aliases.Canonical(space + cells[0]), aliases.Canonical(space + cells[1])}] =
        std::stod(cells[2]);
  }
  std::map<std::pair<std::string, std::string>, double> from_statements;
  for (const PriorRow& row : Read(PriorFormat::kOmics, ReadFile(rdf_file)).rows) {
    from_statements[{row.object, row.place}] = row.count;
  }
  EXPECT_EQ(from_statements, from_counts);
}

}  // namespace
}  // namespace lares::places
