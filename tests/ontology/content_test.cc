#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "ontology/rdf/vocabulary.h"
#include "tests/lares_data.h"
#include "tests/ontology/content.h"

namespace lares::testing {
namespace {

using Names = std::set<std::string>;

const Content& Ours() {
  static const Content content(ModuleFiles());
  return content;
}

// What one module alone declares as `type`.
Names DeclaredIn(const std::string& module, std::string_view type) {
  return Content({SourceFolder() / "ontology" / module}).Declared(type);
}

std::string LongestProblem(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += name + " ";
  return text;
}

TEST(ModulesTest, EachIsOneOntologyNamedAfterItsFile) {
  for (const auto& file : ModuleFiles()) {
    const Content module({file});
    const Names expected = {"https://w3id.org/lares/" + file.stem().string()};
    EXPECT_EQ(module.Declared("owl:Ontology"), expected);
  }
}

TEST(ModulesTest, TheyImportOnlyOneAnother) {
  const Names modules = Ours().Declared("owl:Ontology");
  for (const std::string& module : modules) {
    for (const std::string& import : Ours().Values(module, "owl:imports")) {
      EXPECT_TRUE(modules.contains(import)) << module << " imports " << import;
    }
  }
}

TEST(ModulesTest, EveryClassHasALabelAndAGloss) {
  for (const std::string& name : Ours().Declared("owl:Class")) {
    EXPECT_FALSE(Ours().Values(name, "rdfs:label").empty()) << name;
    EXPECT_FALSE(Ours().Values(name, "rdfs:comment").empty()) << name;
  }
}

TEST(ModulesTest, NoTwoClassesShareALabel) {
  std::map<std::string, Names> named;
  for (const std::string& name : Ours().Declared("owl:Class")) {
    for (const std::string& label : Ours().Values(name, "rdfs:label")) named[label].insert(name);
  }
  for (const auto& [label, names] : named) {
    EXPECT_EQ(names.size(), 1U) << label << ": " << LongestProblem(names);
  }
}

TEST(ModulesTest, EveryTermThatIsUsedIsDeclared) {
  Names undeclared;
  const rdf::View& view = Ours().view();
  view.ForEach({}, [&](const rdf::Triple& triple) {
    for (const rdf::TermId term : {triple.subject, triple.predicate, triple.object}) {
      const rdf::TermView text = view.dictionary().Get(term);
      if (text.kind == rdf::TermKind::kIri && text.value.starts_with(rdf::kLares) &&
          view.Objects(term, Ours().Id("rdf:type")).empty()) {
        undeclared.insert(Ours().Name(term));
      }
    }
    return true;
  });
  EXPECT_TRUE(undeclared.empty()) << LongestProblem(undeclared);
}

TEST(ModulesTest, NoTermIsWrittenUnderAnAlias) {
  const rdf::AliasTable aliases = OurAliases();
  for (const auto& file : ModuleFiles()) {
    for (const rdf::Term& term : ReadDocument(file).terms) {
      if (term.kind != rdf::TermKind::kIri) continue;
      EXPECT_EQ(aliases.Canonical(term.value), term.value) << file;
    }
  }
}

TEST(PlacesTest, ThereAreManyKindsAndTheUsualRoomsAreRooms) {
  int places = 0;
  for (const std::string& name : DeclaredIn("places.ttl", "owl:Class")) {
    places += Ours().Above(name).contains("Place") ? 1 : 0;
  }
  EXPECT_GE(places, 25);
  for (const char* room :
       {"Kitchen", "Office", "Restaurant", "Hallway", "HospitalRoom", "Laboratory", "LockerRoom",
        "ConferenceRoom", "Classroom", "Auditorium"}) {
    EXPECT_TRUE(Ours().Above(room).contains("Room")) << room;
  }
  for (const char* place : {"Home", "Hospital", "Tunnel", "Mine", "OfficeBuilding"}) {
    EXPECT_TRUE(Ours().Above(place).contains("Place")) << place;
  }
}

void ExpectSizes(const Content& content, const std::string& name) {
  for (const char* side : {"typicalWidth_m", "typicalDepth_m", "typicalHeight_m"}) {
    const Names values = content.Values(name, side);
    ASSERT_EQ(values.size(), 1U) << name << " " << side;
    const double size_m = std::stod(*values.begin());
    EXPECT_GT(size_m, 0.001) << name << " " << side;
    EXPECT_LE(size_m, 6.0) << name << " " << side;
  }
}

void ExpectDescribed(const Content& content, const std::string& name) {
  Names parents = content.Values(name, "rdfs:subClassOf");
  std::erase_if(parents, [](const std::string& parent) {
    return parent.find('#') != std::string::npos || parent == "PhysicalObject" ||
           parent == "Artifact" || parent == "SpatialThing";
  });
  EXPECT_FALSE(parents.empty()) << name << " has no specific parent";
  EXPECT_TRUE(content.Above(name).contains("PhysicalObject")) << name;
  ExpectSizes(content, name);
  EXPECT_EQ(content.Values(name, "isLandmark").size(), 1U) << name;
}

TEST(ObjectsTest, EachHasASpecificParentASizeAndALandmarkNote) {
  const Content objects({SourceFolder() / "ontology/objects.ttl"});
  const Names names = objects.Declared("owl:Class");
  EXPECT_GE(names.size(), 150U);
  for (const std::string& name : names) {
    ExpectDescribed(Ours(), name);
  }
}

TEST(ObjectsTest, WhereTheyUsuallyStandIsAPlaceOrAThing) {
  for (const std::string& name : Ours().Declared("owl:Class")) {
    for (const char* property : {"usuallyOn", "usuallyIn"}) {
      for (const std::string& where : Ours().Values(name, property)) {
        EXPECT_TRUE(Ours().Above(where).contains("SpatialThing")) << name << " " << where;
      }
    }
  }
}

TEST(ObjectsTest, ADrinkingBottleIsABottleAndAMugIsACup) {
  EXPECT_TRUE(Ours().Above("DrinkingBottle").contains("Bottle"));
  EXPECT_TRUE(Ours().Above("Mug").contains("Cup"));
  EXPECT_FALSE(Ours().Above("Bottle").contains("DrinkingBottle"));
}

TEST(FurnitureTest, EachPieceAffordsSomething) {
  const Names affordances = Ours().Declared("Affordance");
  const Names names = DeclaredIn("furniture.ttl", "owl:Class");
  EXPECT_GE(names.size(), 30U);
  const rdf::View& view = Ours().view();
  for (const std::string& name : names) {
    ExpectDescribed(Ours(), name);
    Names afforded;
    for (const rdf::TermId parent : view.Objects(Ours().Id(name), Ours().Id("rdfs:subClassOf"))) {
      for (const rdf::TermId value : view.Objects(parent, Ours().Id("owl:hasValue"))) {
        afforded.insert(Ours().Name(value));
      }
    }
    if (name == "RoomDivider") continue;
    EXPECT_FALSE(afforded.empty()) << name;
    for (const std::string& value : afforded) EXPECT_TRUE(affordances.contains(value)) << value;
  }
}

TEST(CapabilitiesTest, AllThirtySevenAreBelowCapability) {
  const Names names = DeclaredIn("capabilities.ttl", "owl:Class");
  EXPECT_EQ(names.size(), 37U);
  for (const std::string& name : names) {
    EXPECT_TRUE(Ours().Above(name).contains("Capability")) << name;
  }
}

TEST(CapabilitiesTest, NeedsOfCapabilitiesAreInherited) {
  EXPECT_EQ(Ours().Some("move_base", "dependsOnComponent"),
            (Names{"MobileBase", "NavigationComponent"}));
  EXPECT_EQ(Ours().Some("move_base", "dependsOnCapability"),
            (Names{"BaseCollisionCheckCapability", "LocalizationCapability"}));
  EXPECT_EQ(
      Ours().Some("GraspingCapability", "dependsOnCapability"),
      (Names{"ArmMotionCapability", "GripperMotionCapability", "ObjectRecognitionCapability"}));
  EXPECT_EQ(Ours().Some("ArmMotionCapability", "dependsOnComponent"),
            (Names{"ArmComponent", "ArmMotionController"}));
  EXPECT_EQ(Ours().Some("VisualSLAMCapability", "dependsOnComponent"),
            (Names{"Camera", "VisualSlamMappingComponent"}));
  EXPECT_TRUE(Ours().Some("HeadMotionCapability", "dependsOnComponent").empty());
}

TEST(ActionsTest, EachNeedsExactlyItsCapabilities) {
  const std::map<std::string, Names> needs = {
      {"Translation-LocationChange", {"BaseMotionCapability"}},
      {"CarryingWhileLocomoting", {"BaseMotionCapability"}},
      {"Perceiving", {"ObjectRecognitionCapability"}},
      {"SemanticMapPerception", {"ObjectRecognitionCapability"}},
      {"re_explore", {"VisualSLAMCapability"}},
      {"EnvironmentExploration", {}},
      {"Reaching", {"ArmMotionCapability"}},
      {"OpeningAGripper", {"GripperMotionCapability"}},
      {"ClosingAGripper", {"GripperMotionCapability"}},
      {"GraspingSomething", {"GraspingCapability"}},
      {"PickingUpAnObject", {"PickingUpAnObjectCapability"}},
      {"PuttingDownAnObject", {"PuttingDownAnObjectCapability"}},
      {"OpeningACupboard", {"OpeningADoorCapability"}},
      {"ClosingADrawer", {"ClosingADrawerCapability"}},
      {"CheckingWhetherConditionObtains", {}},
      {"InferLikelyObjectLocations", {}},
      {"LoadTypicalObjectModels", {}},
      {"StartExplorationModules", {}},
      {"StopExplorationModules", {}},
      {"StartVisionModules", {}},
      {"StopVisionModules", {}},
      {"UploadMapToRoboEarth", {}},
  };
  for (const auto& [action, capabilities] : needs) {
    EXPECT_EQ(Ours().Needs(action), capabilities) << action;
    EXPECT_TRUE(Ours().Above(action).contains("PurposefulAction")) << action;
  }
}

TEST(ActionsTest, NeedsAreCapabilitiesAndComponents) {
  for (const std::string& name : Ours().Declared("owl:Class")) {
    for (const std::string& need : Ours().Some(name, "dependsOnCapability")) {
      EXPECT_TRUE(Ours().Above(need).contains("Capability")) << name << " " << need;
    }
    for (const std::string& need : Ours().Some(name, "dependsOnComponent")) {
      if (!Ours().Declared("owl:Class").contains(need)) continue;  // a union
      EXPECT_TRUE(Ours().Above(need).contains("Component")) << name << " " << need;
    }
  }
}

}  // namespace
}  // namespace lares::testing
