#include <gtest/gtest.h>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "tests/lares_data.h"
#include "tests/ontology/content.h"

namespace lares::testing {
namespace {

using Names = std::set<std::string>;
using Files = std::vector<std::filesystem::path>;

// Documents with everything that follows from them.
class Closed {
 public:
  explicit Closed(const Files& files, bool recover = false)
      : content_(files, recover), view_(content_.view().shared_dictionary()) {
    std::vector<rdf::Graph> graphs = content_.view().layers().front()->graphs();
    view_ = view_.With(owl::Materialise(view_, std::move(graphs)));
  }

  std::vector<std::string> Clashes() const {
    std::vector<std::string> clashes;
    for (const rdf::Clash& clash : view_.layers().back()->clashes()) {
      std::string text = clash.rule;
      for (const rdf::Triple& premise : clash.premises) {
        text += " | " + content_.Name(premise.subject) + " " + content_.Name(premise.predicate) +
                " " + content_.Name(premise.object);
      }
      clashes.push_back(text);
    }
    return clashes;
  }

  bool Holds(const std::string& subject, const std::string& property,
             const std::string& object) const {
    return view_.Contains({content_.Id(subject), content_.Id(property), content_.Id(object)});
  }

  // Fillers of the "some" restrictions on `property` that `name` is inferred to be below.
  Names Some(const std::string& name, const std::string& property) const {
    Names fillers;
    for (const auto parent : view_.Objects(content_.Id(name), content_.Id("rdfs:subClassOf"))) {
      if (!view_.Contains({parent, content_.Id("owl:onProperty"), content_.Id(property)})) continue;
      for (const auto filler : view_.Objects(parent, content_.Id("owl:someValuesFrom"))) {
        fillers.insert(content_.Name(filler));
      }
    }
    return fillers;
  }

  Names Needs(const std::string& task) const {
    Names needs = Some(task, "dependsOnCapability");
    for (const std::string& step : Some(task, "subAction")) {
      if (step != task) needs.merge(Needs(step));
    }
    return needs;
  }

  // Whether the robot has a part of the class, through the axioms of part and kinematic chain.
  bool HasPart(const std::string& robot, const std::string& component) const {
    for (const auto part : view_.Objects(content_.Id(robot), content_.Id("subComponent"))) {
      if (view_.Contains({part, content_.Id("rdf:type"), content_.Id(component)})) return true;
    }
    return false;
  }

 private:
  Content content_;
  rdf::View view_;
};

Files With(Files files, const std::filesystem::path& folder,
           std::initializer_list<const char*> names) {
  for (const char* name : names) files.push_back(folder / name);
  return files;
}

const Closed& OursAndDemonstrations() {
  static const Closed closed(
      With(ModuleFiles(), SourceFolder(),
           {"robots/models/scout.ttl", "robots/models/helper.ttl", "demo/flat.ttl"}));
  return closed;
}

TEST(ClosureTest, OurModulesAndDemonstrationsDoNotContradictThemselves) {
  EXPECT_EQ(OursAndDemonstrations().Clashes(), std::vector<std::string>{});
}

TEST(ClosureTest, PartsFollowFromTheKinematicChain) {
  const std::string helper = "https://w3id.org/lares/robots/helper#";
  const Closed& closed = OursAndDemonstrations();
  EXPECT_TRUE(closed.Holds(helper + "helper1", "subComponent", helper + "left_finger_link"));
  EXPECT_TRUE(closed.Holds(helper + "left_finger_link", "superComponent", helper + "helper1"));
  EXPECT_TRUE(closed.HasPart(helper + "helper1", "ManipulationEntity"));
  const std::string scout = "https://w3id.org/lares/robots/scout#";
  EXPECT_TRUE(closed.HasPart(scout + "scout1", "Camera"));
  EXPECT_FALSE(closed.HasPart(scout + "scout1", "ManipulationEntity"));
}

TEST(ClosureTest, ThingsOfTheFlatAffordWhatTheirKindDoes) {
  const std::string flat = "https://w3id.org/lares/demo/flat#";
  const Closed& closed = OursAndDemonstrations();
  EXPECT_TRUE(closed.Holds(flat + "bed", "affords", "Lying"));
  EXPECT_TRUE(closed.Holds(flat + "coffee_table", "affords", "SupportObjects"));
  EXPECT_FALSE(closed.Holds(flat + "coffee_table", "affords", "Lying"));
  EXPECT_TRUE(closed.Holds(flat + "bottle", "rdf:type", "Bottle"));
  EXPECT_TRUE(closed.Holds(flat + "building", "properPhysicalParts", flat + "cup"));
  EXPECT_TRUE(closed.Holds(flat + "cup", "properPhysicalPartOf", flat + "kitchen"));
}

TEST(ClosureTest, SpatialRelationsHaveTheirCharacteristics) {
  const Closed& closed = OursAndDemonstrations();
  EXPECT_TRUE(closed.Holds("above", "owl:inverseOf", "below"));
  EXPECT_TRUE(closed.Holds("leftOf", "rdfs:subPropertyOf", "spatiallyRelated"));
  EXPECT_TRUE(closed.Holds("nextTo", "rdf:type", "owl:SymmetricProperty"));
  EXPECT_TRUE(closed.Holds("in", "rdf:type", "owl:TransitiveProperty"));
}

// --- With the original files ------------------------------------------------------------------

constexpr std::initializer_list<const char*> kRecipes = {"recipes/object-search-recipe.owl",
                                                         "recipes/exploration-recipe.owl",
                                                         "recipes/serve_drink.owl"};
constexpr std::initializer_list<const char*> kRobots = {"robots/pioneer.owl", "robots/amigo.owl",
                                                        "robots/PR2.owl"};
constexpr std::initializer_list<const char*> kOntologies = {
    "ontology/knowrob.owl", "ontology/roboearth.owl", "srdl/srdl2.owl",
    "srdl/srdl2-comp.owl",  "srdl/srdl2-cap.owl",     "srdl/srdl2-action.owl"};

void ExpectGoldenNeeds(const Closed& closed) {
  EXPECT_EQ(closed.Needs("FindBottle"),
            (Names{"BaseMotionCapability", "ObjectRecognitionCapability"}));
  EXPECT_EQ(closed.Needs("RobotEnvironmentExploration"),
            (Names{"BaseMotionCapability", "VisualSLAMCapability"}));
  EXPECT_EQ(closed.Needs("http://www.roboearth.org/kb/serve_drink.owl#ServeADrink"),
            (Names{"ArmMotionCapability", "BaseMotionCapability", "GraspingCapability",
                   "GripperMotionCapability"}));
}

void ExpectGoldenParts(const Closed& closed) {
  const std::string pioneer = "http://ias.cs.tum.edu/kb/ari.owl#ari_robot1";
  const std::string amigo = "http://ias.cs.tum.edu/kb/amigo.owl#amigo_robot1";
  const std::string pr2 = "http://ias.cs.tum.edu/kb/PR2.owl#PR2Robot1";
  for (const std::string& robot : {pioneer, amigo, pr2}) {
    for (const char* part :
         {"MobileBase", "Camera", "ObjectRecognitionComponent", "ObjectRecognitionModel"}) {
      EXPECT_TRUE(closed.HasPart(robot, part)) << robot << " " << part;
    }
    EXPECT_EQ(closed.HasPart(robot, "VisualSlamMappingComponent"), robot != pr2) << robot;
    for (const char* part : {"ArmComponent", "ArmMotionController", "ManipulationEntity"}) {
      EXPECT_EQ(closed.HasPart(robot, part), robot != pioneer) << robot << " " << part;
    }
    EXPECT_TRUE(closed.Holds(robot, "rdf:type", "Robot")) << robot;
  }
}

TEST(OriginalFilesClosureTest, TheSameNeedsAndPartsWithOurModulesAlone) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  const Closed closed(With(With(ModuleFiles(), folder, kRecipes), folder, kRobots), true);
  ExpectGoldenNeeds(closed);
  ExpectGoldenParts(closed);
  EXPECT_EQ(closed.Clashes(), std::vector<std::string>{});
}

TEST(OriginalFilesClosureTest, TheSameNeedsAndPartsBesideTheOriginalOntologies) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  const Closed closed(
      With(With(With(ModuleFiles(), folder, kOntologies), folder, kRecipes), folder, kRobots),
      true);
  ExpectGoldenNeeds(closed);
  ExpectGoldenParts(closed);
}

TEST(OriginalFilesClosureTest, OurModulesDoNotContradictTheOriginalOntologies) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  EXPECT_EQ(Closed(With(ModuleFiles(), folder, kOntologies)).Clashes(), std::vector<std::string>{});
}

TEST(OriginalFilesClosureTest, MapsDoNotContradictOurModules) {
  LARES_REQUIRE_DATA(folder, "roboearth/maps");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    Files files = ModuleFiles();
    files.push_back(entry.path());
    EXPECT_EQ(Closed(files).Clashes(), std::vector<std::string>{}) << entry.path();
  }
}

}  // namespace
}  // namespace lares::testing
