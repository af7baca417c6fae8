#include "mapping/semantic/map_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::semantic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr char kPrefixes[] =
    "@prefix : <http://example.org/room#> .\n"
    "@prefix lares: <https://w3id.org/lares#> .\n"
    "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n";

rdf::Graph ReadGraph(const std::string& turtle, const std::string& name,
                     rdf::Dictionary& dictionary) {
  rdf::ReadOptions options;
  options.source = name;
  const rdf::Document document = rdf::ReadRdf(kPrefixes + turtle, rdf::Format::kTurtle, options);
  return rdf::MakeGraph(document, name, rdf::AliasTable(), dictionary);
}

// A map over a catalogue; `inferred` is what reasoning would add to the map.
rdf::View MapView(const std::string& map, const std::string& catalogue = "",
                  const std::string& inferred = "") {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  rdf::View view(dictionary);
  const auto layer = [&](const std::string& turtle, const std::string& name,
                         std::vector<rdf::Triple> also) {
    std::vector<rdf::Graph> graphs;
    graphs.push_back(ReadGraph(turtle, name, *dictionary));
    return std::make_shared<const rdf::Layer>(std::move(graphs), std::move(also),
                                              std::vector<rdf::Clash>());
  };
  view = view.With(layer(catalogue, "catalogue", {}));
  return view.With(layer(map, "map", ReadGraph(inferred, "inferred", *dictionary).triples));
}

// ":name" as a matrix: quarter turn about z (the object's x is the map's y), then moved.
std::string Matrix(const std::string& name, double x_m, double y_m, double z_m,
                   const std::string& more = "") {
  const auto position = [](double metres) { return std::to_string(metres); };
  return ":" + name + " a lares:RotationMatrix3D ;\n" +
         " lares:m00 0.0 ; lares:m01 -1.0 ; lares:m02 0.0 ; lares:m03 " + position(x_m) +
         " ;\n lares:m10 1.0 ; lares:m11 0.0 ; lares:m12 0.0 ; lares:m13 " + position(y_m) +
         " ;\n lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 1.0 ; lares:m23 " + position(z_m) +
         " ;\n lares:m30 0.0 ; lares:m31 0.0 ; lares:m32 0.0 ; lares:m33 1.0 " + more + " .\n";
}

std::string Perception(const std::string& name, const std::string& object,
                       const std::string& matrix, const std::string& time = "timepoint_100") {
  return ":" + name + " a lares:SemanticMapPerception ; lares:objectActedOn :" + object +
         " ; lares:eventOccursAt :" + matrix + " ; lares:startTime :" + time + " .\n";
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

std::string Refused(const rdf::View& view) {
  try {
    ReadMapObjects(view);
  } catch (const Error& error) {
    return error.code() == Code::kInvalid ? error.FullMessage() : "not kInvalid";
  }
  return "";
}

MapObject Only(const rdf::View& view) {
  const std::vector<MapObject> objects = ReadMapObjects(view);
  EXPECT_THAT(objects, SizeIs(1));
  return objects.at(0);
}

TEST(MapObjectTest, PerceivedObjectHasClassPoseExtentAndTime) {
  const MapObject bed =
      Only(MapView(":bed1 a owl:NamedIndividual , lares:Bed ; rdfs:label \"the bed\" ;\n"
                   " lares:depthOfObject 2.0 ; lares:widthOfObject \"0.9\"^^xsd:float ;\n"
                   " lares:heightOfObject 0.7 .\n" +
                   Matrix("pose", 1, 2, 0.35) + Perception("seen", "bed1", "pose")));
  EXPECT_EQ(bed.iri, "http://example.org/room#bed1");
  EXPECT_EQ(bed.label, "the bed");
  EXPECT_EQ(bed.class_iri, "https://w3id.org/lares#Bed");
  ASSERT_TRUE(bed.map_from_object && bed.extent_m);
  EXPECT_TRUE((*bed.map_from_object * Eigen::Vector3d(1, 0, 0))
                  .isApprox(Eigen::Vector3d(1, 3, 0.35), 1e-12));
  EXPECT_TRUE(bed.extent_m->isApprox(Eigen::Vector3d(2, 0.9, 0.7)));
  EXPECT_EQ(ToRfc3339(*bed.first_seen), "1970-01-01T00:01:40.000Z");
  EXPECT_EQ(bed.first_seen, bed.last_seen);
  EXPECT_THAT(bed.remarks, IsEmpty());
}

TEST(MapObjectTest, LatestPerceptionGivesThePose) {
  const MapObject cup =
      Only(MapView(Matrix("a", 1, 0, 0) + Matrix("b", 2, 0, 0) + Matrix("c", 3, 0, 0) +
                   Perception("p1", "cup", "a", "t_200.5") +
                   Perception("p2", "cup", "b", "t_1000") + Perception("p3", "cup", "c", "t_50")));
  EXPECT_EQ(cup.map_from_object->translation_m.x(), 2);
  EXPECT_EQ(ToRfc3339(*cup.first_seen), "1970-01-01T00:00:50.000Z");
  EXPECT_EQ(ToRfc3339(*cup.last_seen), "1970-01-01T00:16:40.000Z");
}

TEST(MapObjectTest, PerceptionWithoutTimeIsTheOldest) {
  const MapObject cup = Only(MapView(
      Matrix("a", 1, 0, 0) + Matrix("b", 2, 0, 0) + Perception("p1", "cup", "a", "t_5") +
      ":p2 a lares:SemanticMapPerception ; lares:objectActedOn :cup ; lares:eventOccursAt :b .\n"));
  EXPECT_EQ(cup.map_from_object->translation_m.x(), 1);
}

TEST(MapObjectTest, UnreadableTimeIsRemarkedOn) {
  const MapObject cup =
      Only(MapView(Matrix("a", 1, 0, 0) + Perception("p", "cup", "a", "yesterday")));
  EXPECT_FALSE(cup.first_seen);
  EXPECT_THAT(cup.remarks, ElementsAre(HasSubstr("yesterday")));
}

TEST(MapObjectTest, ObjectsDescribedInAMapNeedNoPose) {
  const MapObject room = Only(MapView(
      ":room1 a lares:HospitalRoom ; lares:describedInMap :map1 . :map1 a lares:OctoMap ."));
  EXPECT_FALSE(room.map_from_object);
  EXPECT_EQ(room.class_iri, "https://w3id.org/lares#HospitalRoom");
}

TEST(MapObjectTest, OwnMatrixServesWithoutPerceptions) {
  const MapObject cup =
      Only(MapView(":cup a lares:Cup ; lares:orientation :m .\n" + Matrix("m", 1, 2, 3)));
  EXPECT_EQ(cup.map_from_object->translation_m.z(), 3);
}

TEST(MapObjectTest, EntriesOfOurVocabularyAreReadAsTheirObjects) {
  const MapObject cup =
      Only(MapView(":entry a lares:MapObject ; lares:standsFor :cup ; lares:orientation :m ;\n"
                   " lares:existenceProbability 0.8 ; lares:firstSeen "
                   "\"2026-01-01T12:00:00+02:00\"^^xsd:dateTime"
                   " ;\n lares:lastSeen \"2026-01-02T12:00:00Z\"^^xsd:dateTime ;\n"
                   " lares:recognizedUsingModel :cup-model . :cup a lares:Cup .\n" +
                   Matrix("m", 1, 2, 3)));
  EXPECT_EQ(cup.iri, "http://example.org/room#cup");
  EXPECT_EQ(cup.class_iri, "https://w3id.org/lares#Cup");
  EXPECT_EQ(cup.existence, 0.8);
  EXPECT_EQ(ToRfc3339(*cup.first_seen), "2026-01-01T10:00:00.000Z");
  EXPECT_EQ(ToRfc3339(*cup.last_seen), "2026-01-02T12:00:00.000Z");
  EXPECT_EQ(cup.recognised_with, "http://example.org/room#cup-model");
  EXPECT_TRUE(cup.map_from_object);
}

TEST(MapObjectTest, ModelOfTheLatestPerceptionWins) {
  const MapObject cup =
      Only(MapView(Matrix("a", 1, 0, 0) + Perception("p1", "cup", "a", "t_1") +
                   Perception("p2", "cup", "a", "t_2") +
                   ":p1 lares:recognizedUsingModel :old . :p2 lares:recognizedUsingModel :new ."));
  EXPECT_EQ(cup.recognised_with, "http://example.org/room#new");
}

TEST(MapObjectTest, MostSpecificClassIsChosen) {
  const std::string map =
      ":cup a lares:Container , lares:Cup , owl:Thing ; lares:describedInMap :m .";
  const std::string classes = "lares:Cup rdfs:subClassOf lares:Container .";
  EXPECT_EQ(Only(MapView(map, classes)).class_iri, "https://w3id.org/lares#Cup");
  EXPECT_EQ(Only(MapView(map)).class_iri, "https://w3id.org/lares#Container");  // first by name
}

TEST(MapObjectTest, EquivalentClassesDoNotHideEachOther) {
  const std::string map = ":cup a lares:Cup , lares:Mug ; lares:describedInMap :m .";
  EXPECT_EQ(Only(MapView(map,
                         "lares:Cup rdfs:subClassOf lares:Mug . lares:Mug rdfs:subClassOf "
                         "lares:Cup ."))
                .class_iri,
            "https://w3id.org/lares#Cup");
}

TEST(MapObjectTest, InferredSubclassBeatsTheAssertedClass) {
  EXPECT_EQ(Only(MapView(":x a lares:Container ; lares:describedInMap :m .",
                         "lares:Cup rdfs:subClassOf lares:Container .", ":x a lares:Cup ."))
                .class_iri,
            "https://w3id.org/lares#Cup");
}

TEST(MapObjectTest, LowerLayersAddNoObjectsButSayWhatTheyAre) {
  const rdf::View view =
      MapView(":cup lares:describedInMap :m .",
              ":other lares:describedInMap :m . :cup rdfs:label \"my cup\" ; a lares:Cup .");
  EXPECT_EQ(Only(view).label, "my cup");
}

TEST(MapObjectTest, MapsMatricesAndActionsAreNoObjects) {
  EXPECT_THAT(ReadMapObjects(MapView(":map1 a lares:SemanticEnvironmentMap .\n" +
                                     Matrix("m", 0, 0, 0) + Perception("p", "map1", "m") +
                                     ":grasp a lares:Grasping ; lares:objectActedOn :cup .")),
              IsEmpty());
}

TEST(MapObjectTest, PerceptionAtAPlaceHasNoPose) {
  const MapObject cup =
      Only(MapView(":kitchen a lares:Kitchen .\n" + Perception("p", "cup", "kitchen")));
  EXPECT_FALSE(cup.map_from_object);
  EXPECT_TRUE(cup.first_seen);
}

TEST(MapObjectTest, RelativeMatricesAreComposed) {
  const MapObject handle = Only(MapView(Perception("p", "handle", "m3") + Matrix("m1", 1, 2, 0) +
                                        Matrix("m2", 1, 0, 0, "; lares:relativeTo :m1") +
                                        Matrix("m3", 0, 0, 1, "; lares:relativeTo :m2")));
  // m1 turns m2's x into y; all three turn by a quarter.
  EXPECT_TRUE(handle.map_from_object->translation_m.isApprox(Eigen::Vector3d(1, 3, 1), 1e-12));
  EXPECT_NEAR(YawRad(*handle.map_from_object), -M_PI / 2, 1e-12);
}

TEST(MapObjectTest, MatrixMayBeRelativeToAnObjectOrTheMap) {
  const std::vector<MapObject> objects = ReadMapObjects(
      MapView(":map1 a lares:SemanticEnvironmentMap .\n" + Perception("p1", "door", "m1") +
              Perception("p2", "handle", "m2") + Matrix("m1", 1, 2, 0, "; lares:relativeTo :map1") +
              Matrix("m2", 1, 0, 0.5, "; lares:relativeTo :door")));
  ASSERT_THAT(objects, SizeIs(2));
  EXPECT_TRUE(
      objects[1].map_from_object->translation_m.isApprox(Eigen::Vector3d(1, 3, 0.5), 1e-12));
}

TEST(MapObjectTest, MatrixRelativeToAClassGivesNoPoseButARemark) {
  const MapObject handle = Only(
      MapView(Perception("p", "handle", "m") + Matrix("m", 1, 2, 0, "; lares:relativeTo :Door")));
  EXPECT_FALSE(handle.map_from_object);
  EXPECT_THAT(handle.remarks, ElementsAre(HasSubstr("#Door>, which has no pose")));
}

TEST(MapObjectTest, FramesInACircleAreRefusedByName) {
  EXPECT_THAT(Refused(MapView(Perception("p", "cup", "m1") +
                              Matrix("m1", 0, 0, 0, "; lares:relativeTo :m2") +
                              Matrix("m2", 0, 0, 0, "; lares:relativeTo :m1"))),
              HasSubstr("object <http://example.org/room#cup>: frames are relative to one another: "
                        "<http://example.org/room#m1> → <http://example.org/room#m2> → "
                        "<http://example.org/room#m1>"));
  EXPECT_THAT(Refused(MapView(Perception("p", "cup", "m") +
                              Matrix("m", 0, 0, 0, "; lares:relativeTo :cup"))),
              HasSubstr("#m> → <http://example.org/room#m>"));
}

TEST(MapObjectTest, EndlessChainOfFramesIsRefused) {
  std::string map = Perception("p", "cup", "m0");
  for (int i = 0; i < 1000; ++i) {
    map +=
        Matrix("m" + std::to_string(i), 0, 0, 0, "; lares:relativeTo :m" + std::to_string(i + 1));
  }
  EXPECT_THROW(ReadMapObjects(MapView(map)), Error);
}

TEST(MapObjectTest, FaultsInMatricesNameObjectMatrixAndEntry) {
  const std::string good = Matrix("m", 1, 2, 3) + Perception("p", "cup", "m");
  const auto refused = [&](const std::string& what, const std::string& with) {
    return Refused(MapView(Replaced(good, what, with)));
  };
  EXPECT_THAT(refused("lares:m13 2.000000", "lares:m13 \"NaN\"^^xsd:double"),
              AllOf(HasSubstr("object <http://example.org/room#cup>"),
                    HasSubstr("<http://example.org/room#m>: entry m13 is not a finite number")));
  EXPECT_THAT(refused("lares:m13 2.000000", "lares:m13 \"wide\""), HasSubstr("entry m13 is not"));
  EXPECT_THAT(refused("lares:m13 2.000000", "lares:m13 2.0 , 2.5"),
              HasSubstr("entry m13 has two different values"));
  EXPECT_EQ(refused("lares:m13 2.000000", "lares:m13 2.0 , 2.00"), "");
  EXPECT_THAT(refused("lares:m13 2.000000 ;", ""),
              HasSubstr("pose matrix <http://example.org/room#m>: entry m13 is missing"));
  EXPECT_THAT(refused("lares:m22 1.0", "lares:m22 1.1"), HasSubstr("is no rotation"));
  EXPECT_THAT(refused("lares:m33 1.0", "lares:m33 2.0"), HasSubstr("last row"));
  EXPECT_THAT(Refused(MapView(Perception("p", "cup", "absent"))),
              HasSubstr("#absent>: entry m00 is missing"));
  EXPECT_THAT(Refused(MapView(good + Matrix("n", 0, 0, 0) + ":p lares:eventOccursAt :n .")),
              HasSubstr("has two pose matrices"));
}

TEST(MapObjectTest, RoundedRotationsAreMadeExact) {
  std::string matrix = Matrix("m", 1, 2, 3);
  matrix = Replaced(matrix, "lares:m00 0.0", "lares:m00 0.71");
  matrix = Replaced(matrix, "lares:m01 -1.0", "lares:m01 -0.71");
  matrix = Replaced(matrix, "lares:m10 1.0", "lares:m10 0.71");
  matrix = Replaced(matrix, "lares:m11 0.0", "lares:m11 0.71");
  const MapObject cup = Only(MapView(matrix + Perception("p", "cup", "m")));
  EXPECT_NEAR(YawRad(*cup.map_from_object), M_PI / 4, 1e-12);
  EXPECT_NEAR(cup.map_from_object->rotation.norm(), 1, 1e-12);
}

TEST(MapObjectTest, MirroredMatrixIsTurnedIntoARotationWithARemark) {
  const std::string matrix = Replaced(Matrix("m", 1, 2, 3), "lares:m01 -1.0", "lares:m01 1.0");
  const MapObject hinge = Only(MapView(matrix + Perception("p", "hinge", "m")));
  EXPECT_THAT(hinge.remarks, ElementsAre(HasSubstr("mirrors")));
  // x and z stay.
  EXPECT_TRUE((hinge.map_from_object->rotation * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE((hinge.map_from_object->rotation * Eigen::Vector3d::UnitZ())
                  .isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST(MapObjectTest, WrongSizesAndProbabilitiesAreRefused) {
  const auto refused = [](const std::string& what) {
    return Refused(MapView(":cup lares:describedInMap :m ; " + what + " ."));
  };
  EXPECT_THAT(refused("lares:widthOfObject \"NaN\"^^xsd:double"),
              HasSubstr("widthOfObject is not"));
  EXPECT_THAT(refused("lares:depthOfObject -1"), HasSubstr("shorter than nothing"));
  EXPECT_THAT(refused("lares:existenceProbability 1.5"), HasSubstr("between 0 and 1"));
  EXPECT_THAT(refused("lares:firstSeen \"yesterday\""), HasSubstr("firstSeen is not a time"));
}

TEST(MapObjectTest, ThreeZeroSidesAreNoExtentButOneIs) {
  const auto object = [](const std::string& depth) {
    return Only(MapView(":door lares:describedInMap :m ; lares:depthOfObject " + depth +
                        " ; lares:widthOfObject " + depth + " ; lares:heightOfObject 0.0 ."));
  };
  EXPECT_FALSE(object("0.0").extent_m);
  EXPECT_TRUE(object("0.3").extent_m);
}

TEST(MapObjectTest, BoundsCoverTurnedBoxes) {
  const std::vector<MapObject> objects = ReadMapObjects(MapView(
      ":bed lares:depthOfObject 2.0 ; lares:widthOfObject 1.0 ; lares:heightOfObject 0.5 .\n" +
      Matrix("m", 10, 20, 0.25) + Perception("p", "bed", "m")));
  const auto bounds = BoundsOf(objects);
  ASSERT_TRUE(bounds);
  const double expected[] = {9.5, 19, 0, 10.5, 21, 0.5};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR((*bounds)[i], expected[i], 1e-12) << i;
  EXPECT_FALSE(BoundsOf({}));
}

TEST(MapObjectTest, ViewWithoutLayersHasNoObjects) {
  EXPECT_THAT(ReadMapObjects(rdf::View(std::make_shared<rdf::Dictionary>())), IsEmpty());
}

}  // namespace
}  // namespace lares::semantic
