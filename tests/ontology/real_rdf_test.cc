// RDF that others made: read, repaired and written again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/file.h"
#include "tests/lares_data.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using testing::AreIsomorphic;
using testing::FaultOf;
using testing::Named;

std::vector<std::filesystem::path> OwlFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".owl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Document ReadFileOf(const std::filesystem::path& path, bool recover) {
  ReadOptions options = Named(path.filename().string());
  options.recover = recover;
  return ReadRdf(ReadFile(path), GuessFormat("", path.filename().string(), ""), options);
}

TEST(RealRdf, EveryRoboEarthFileButOneIsRead) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  const auto files = OwlFiles(folder);
  EXPECT_EQ(files.size(), 23u);
  for (const auto& file : files) {
    if (file.filename() == "exploration-recipe.owl") continue;
    EXPECT_GE(ReadFileOf(file, false).statements.size(), 4u) << file;
  }
}

TEST(RealRdf, CountsOfStatementsAreThoseOfAnIndependentParser) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  EXPECT_EQ(ReadFileOf(folder / "ontology/knowrob.owl", false).statements.size(), 4072u);
  EXPECT_EQ(ReadFileOf(folder / "robots/PR2.owl", false).statements.size(), 4363u);
  EXPECT_EQ(ReadFileOf(folder / "robots/amigo.owl", false).statements.size(), 5089u);
  EXPECT_EQ(ReadFileOf(folder / "robots/pioneer.owl", false).statements.size(), 857u);
  EXPECT_EQ(ReadFileOf(folder / "recipes/serve_drink.owl", false).statements.size(), 414u);
}

TEST(RealRdf, MalformedCommentOfTheExplorationRecipeIsRefused) {
  LARES_REQUIRE_DATA(file, "roboearth/recipes/exploration-recipe.owl");
  const Error error = FaultOf(ReadFile(file), Format::kRdfXml, Named("exploration-recipe.owl"));
  EXPECT_EQ(error.FullMessage(),
            "exploration-recipe.owl:715:6: malformed comment '<!-annotation property for HMI-->'");
}

TEST(RealRdf, ExplorationRecipeIsRepairedAtOnePlace) {
  LARES_REQUIRE_DATA(file, "roboearth/recipes/exploration-recipe.owl");
  const Document document = ReadFileOf(file, true);
  // 266 before the comment, and the annotation property after it.
  EXPECT_EQ(document.statements.size(), 267u);
  ASSERT_EQ(document.remarks.size(), 1u);
  EXPECT_EQ(document.remarks[0].kind, Remark::Kind::kRepair);
  EXPECT_EQ(ToString(document.remarks[0].place), "exploration-recipe.owl:715:5");
}

TEST(RealRdf, SoundFilesNeedNoRepair) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  for (const auto& file : OwlFiles(folder)) {
    if (file.filename() == "exploration-recipe.owl") continue;
    for (const Remark& remark : ReadFileOf(file, true).remarks) {
      EXPECT_EQ(remark.kind, Remark::Kind::kWarning) << file << remark.message;
    }
  }
}

TEST(RealRdf, EveryFileIsTheSameAfterWritingInEveryFormat) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  for (const auto& file : OwlFiles(folder)) {
    const Document document = ReadFileOf(file, true);
    for (const Format format : {Format::kRdfXml, Format::kTurtle, Format::kTriG, Format::kNTriples,
                                Format::kNQuads, Format::kJsonLd}) {
      const std::string text = WriteRdf(document, format);
      const Document again = ReadRdf(text, format, Named("written"));
      EXPECT_TRUE(AreIsomorphic(document, again)) << file << " as " << MediaType(format);
    }
  }
}

TEST(RealRdf, OmicsStatementsAreRead) {
  LARES_REQUIRE_DATA(file, "priors/omics/locations.rdf");
  EXPECT_EQ(ReadFileOf(file, false).statements.size(), 1380u);
}

}  // namespace
}  // namespace lares::rdf
