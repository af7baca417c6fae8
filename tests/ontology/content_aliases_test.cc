#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/file.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/places/prior.h"
#include "tests/lares_data.h"
#include "tests/ontology/content.h"

namespace lares::testing {
namespace {

using Names = std::set<std::string>;

const Content& Ours() {
  static const Content content(ModuleFiles());
  return content;
}

bool IsDeclared(const std::string& iri) {
  const rdf::TermId term = Ours().Id(iri);
  return term != rdf::kAnyTerm && !Ours().view().Objects(term, Ours().Id("rdf:type")).empty();
}

TEST(AliasesTest, EveryRenamingLeadsToATermOfOurs) {
  const rdf::AliasTable table = OurAliases();
  int renamings = 0;
  for (const rdf::Alias& alias : table.aliases()) {
    EXPECT_FALSE(alias.reason.empty()) << alias.alias;
    if (alias.is_namespace) {
      EXPECT_EQ(alias.canonical, rdf::kLares) << alias.alias;
      continue;
    }
    ++renamings;
    EXPECT_TRUE(IsDeclared(alias.canonical)) << alias.canonical;
    EXPECT_FALSE(IsDeclared(alias.alias)) << alias.alias << " is a term of ours too";
  }
  EXPECT_GT(renamings, 50);
}

TEST(AliasesTest, EveryHistoricNamespaceMeansOurs) {
  const rdf::AliasTable table = OurAliases();
  for (const char* host :
       {"http://ias.cs.tum.edu/kb/", "http://www.roboearth.org/kb/", "http://knowrob.org/kb/"}) {
    for (const char* module : {"knowrob", "roboearth", "srdl2", "srdl2-comp", "srdl2-cap",
                               "srdl2-action", "knowrob.owl"}) {
      const std::string space = std::string(host) + module + ".owl#";
      EXPECT_EQ(table.Canonical(space + "Cup"), "https://w3id.org/lares#Cup") << space;
      EXPECT_EQ(table.Canonical(space + "Bed-PieceOfFurniture"), "https://w3id.org/lares#Bed");
    }
  }
}

TEST(AliasesTest, TwoNotionsWithOneLocalNameStayApart) {
  const rdf::AliasTable table = OurAliases();
  for (const char* name : {"Clock", "origin", "near"}) {
    EXPECT_NE(table.Canonical(std::string("http://ias.cs.tum.edu/kb/srdl2-comp.owl#") + name),
              table.Canonical(std::string("http://ias.cs.tum.edu/kb/knowrob.owl#") + name))
        << name;
  }
  EXPECT_EQ(table.Canonical("http://ias.cs.tum.edu/kb/srdl2-comp.owl#Camera"),
            table.Canonical("http://ias.cs.tum.edu/kb/knowrob.owl#Camera"));
}

TEST(OurPriorTest, RowsNameKnownThingsAndPlacesAndTheirSource) {
  const std::string bytes = lares::ReadFile(SourceFolder() / "ontology/priors/lares.tsv");
  const places::PriorTable table =
      places::ReadPrior(bytes, places::PriorFormat::kTsv, "lares", OurAliases());
  EXPECT_FALSE(table.title.empty());
  std::map<std::string, std::pair<int, int>> rooms_and_things;
  for (const places::PriorRow& row : table.rows) {
    EXPECT_FALSE(row.source.empty()) << row.object << " " << row.place;
    EXPECT_TRUE(Ours().Above(row.object).contains("PhysicalObject")) << row.object;
    const Names above = Ours().Above(row.place);
    EXPECT_TRUE(above.contains("Room") || above.contains("Place") ||
                above.contains("PhysicalObject"))
        << row.place;
    auto& [rooms, things] = rooms_and_things[row.object];
    (above.contains("Place") ? rooms : things) += 1;
  }
  EXPECT_GE(rooms_and_things.size(), 60U);
  for (const char* object : {"Cup", "Bottle", "Mug", "Book", "Towel"}) {
    const auto& [rooms, things] = rooms_and_things[std::string(rdf::kLares) + object];
    EXPECT_GE(rooms, 2) << object;
    EXPECT_GE(things, 2) << object;
  }
}

TEST(OurPriorTest, ACupIsMostProbablyInAKitchen) {
  const std::string bytes = lares::ReadFile(SourceFolder() / "ontology/priors/lares.tsv");
  const places::PriorTable table =
      places::ReadPrior(bytes, places::PriorFormat::kTsv, "lares", OurAliases());
  const auto ranked = places::RankPlaces(table, std::string(rdf::kLares) + "Cup");
  const auto room = std::find_if(ranked.begin(), ranked.end(), [](const auto& place) {
    return Ours().Above(place.place).contains("Room");
  });
  ASSERT_NE(room, ranked.end());
  EXPECT_EQ(room->place, std::string(rdf::kLares) + "Kitchen");
}

// --- With the original files ------------------------------------------------------------------

std::vector<std::filesystem::path> With(std::vector<std::filesystem::path> files,
                                        const std::filesystem::path& folder,
                                        std::initializer_list<const char*> names) {
  for (const char* name : names) files.push_back(folder / name);
  return files;
}

void ExpectGoldenNeeds(const Content& content) {
  EXPECT_EQ(content.Needs("FindBottle"),
            (Names{"BaseMotionCapability", "ObjectRecognitionCapability"}));
  EXPECT_EQ(content.Needs("RobotEnvironmentExploration"),
            (Names{"BaseMotionCapability", "VisualSLAMCapability"}));
  EXPECT_EQ(content.Needs("http://www.roboearth.org/kb/serve_drink.owl#ServeADrink"),
            (Names{"ArmMotionCapability", "BaseMotionCapability", "GraspingCapability",
                   "GripperMotionCapability"}));
}

constexpr std::initializer_list<const char*> kRecipes = {"recipes/object-search-recipe.owl",
                                                         "recipes/exploration-recipe.owl",
                                                         "recipes/serve_drink.owl"};
constexpr std::initializer_list<const char*> kOntologies = {
    "ontology/knowrob.owl", "ontology/roboearth.owl", "srdl/srdl2.owl",
    "srdl/srdl2-comp.owl",  "srdl/srdl2-cap.owl",     "srdl/srdl2-action.owl"};

TEST(OriginalFilesTest, RecipesNeedTheSameWithOurModulesAlone) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  ExpectGoldenNeeds(Content(With(ModuleFiles(), folder, kRecipes), true));
}

TEST(OriginalFilesTest, RecipesNeedTheSameBesideTheOriginalOntologies) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  ExpectGoldenNeeds(
      Content(With(With(ModuleFiles(), folder, kRecipes), folder, kOntologies), true));
}

TEST(OriginalFilesTest, OurClassesAndTheirsFormNoCircle) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  const Content content(With(ModuleFiles(), folder, kOntologies));
  for (const std::string& name : content.Declared("owl:Class")) {
    for (const std::string& above : content.Above(name)) {
      if (above == name) continue;
      EXPECT_FALSE(content.Above(above).contains(name)) << name << " " << above;
    }
  }
}

TEST(OriginalFilesTest, EveryClassOfTheMapsIsOurs) {
  LARES_REQUIRE_DATA(folder, "roboearth/maps");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Content map({entry.path()});
    const rdf::View& view = map.view();
    view.ForEach({{}, map.Id("rdf:type"), {}}, [&](const rdf::Triple& triple) {
      const std::string_view iri = view.dictionary().Get(triple.object).value;
      if (iri.find("www.w3.org") == std::string_view::npos) {
        EXPECT_TRUE(IsDeclared(std::string(iri))) << entry.path() << " " << iri;
      }
      return true;
    });
  }
}

TEST(OriginalFilesTest, NoTwoClassesOfOmicsBecomeOne) {
  LARES_REQUIRE_DATA(file, "priors/omics/locations.rdf");
  const places::PriorTable table =
      places::ReadPrior(lares::ReadFile(file), places::PriorFormat::kOmics, "omics", OurAliases());
  const places::PriorIndex index(table);
  EXPECT_EQ(index.object_count(), 271U);
  EXPECT_EQ(index.places().size(), 10U);
  for (const std::string& place : index.places()) {
    EXPECT_TRUE(Ours().Above(place).contains("Room")) << place;
  }
}

}  // namespace
}  // namespace lares::testing
