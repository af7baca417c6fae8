// What environments are found by, and what belongs where: over the closed catalogue.
#include "mapping/semantic/place_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text.h"
#include "tests/lares_data.h"
#include "tests/recipes/world.h"

namespace lares::semantic {
namespace {

using lares::testing::World;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

std::string Lares(const std::string& local) { return "https://w3id.org/lares#" + local; }

struct Read {
  std::vector<MapObject> objects;
  PlaceFacts facts;

  const MapObject& Named(std::string_view local) const {
    for (const MapObject& object : objects) {
      if (LocalName(object.iri) == local) return object;
    }
    throw std::runtime_error("no object " + std::string(local));
  }
};

Read ReadView(const rdf::View& view) {
  Read read;
  read.objects = ReadMapObjects(view);
  read.facts = ReadPlaceFacts(view, read.objects);
  return read;
}

Read ReadMap(const std::string& turtle) {
  World world;
  world.Put("map", lares::testing::Turtle(turtle));
  return ReadView(world.view());
}

Read ReadFile(const std::filesystem::path& file) {
  World world;
  world.PutFile("map", file);
  return ReadView(world.view());
}

const char kAddress[] =
    ":city a lares:City ; rdfs:label \"Zaragoza\"@es , \"Saragossa\"@en ; "
    "lares:properPhysicalParts :street .\n"
    ":street a lares:Street ; rdfs:label \"Calle Mayor\" ; lares:properPhysicalParts :house .\n"
    ":house a lares:Building ; rdfs:label \"clinic\" ; lares:streetNumber \"12\" ; "
    "lares:properPhysicalParts :level .\n"
    ":level a lares:Storey ; lares:floorNumber \"3\" ; lares:properPhysicalParts :room .\n"
    ":room a lares:HospitalRoom ; lares:roomNumber \"3001\" ; lares:describedInMap :map .\n"
    ":map a lares:SemanticEnvironmentMap .\n";

TEST(PlaceFactsTest, TheAddressOfARoom) {
  const PlaceFacts facts = ReadMap(kAddress).facts;
  EXPECT_THAT(facts.room_numbers, ElementsAre("3001"));
  EXPECT_THAT(facts.levels, ElementsAre("3"));
  EXPECT_THAT(facts.buildings, ElementsAre("12", "clinic"));
  EXPECT_THAT(facts.streets, ElementsAre("Calle Mayor"));
  EXPECT_THAT(facts.cities, ElementsAre("Saragossa", "Zaragoza"));
  EXPECT_THAT(facts.place_classes,
              AllOf(IsSupersetOf({Lares("HospitalRoom"), Lares("Room"), Lares("Place")}),
                    Not(Contains(Lares("Building"))), Not(Contains(Lares("City")))));
  EXPECT_THAT(facts.map_classes, IsSupersetOf({Lares("SemanticEnvironmentMap"), Lares("Map")}));
  EXPECT_THAT(facts.held_classes, IsEmpty());
}

TEST(PlaceFactsTest, PartsWrittenTheOtherWayRoundAreUnderstood) {
  const PlaceFacts facts =
      ReadMap(
          ":street a lares:Street ; rdfs:label \"Karlstrasse\" .\n"
          ":house a lares:Building ; lares:streetNumber \"45\" ; "
          "lares:properPhysicalParts :street .\n"
          ":level a lares:Storey ; lares:floorNumber \"3\" ; lares:properPhysicalParts :house "
          ".\n:room a lares:Kitchen ; lares:roomNumber \"7\" ; lares:properPhysicalParts :level "
          "; lares:describedInMap :map .\n")
          .facts;
  EXPECT_THAT(facts.room_numbers, ElementsAre("7"));
  EXPECT_THAT(facts.levels, ElementsAre("3"));
  EXPECT_THAT(facts.buildings, ElementsAre("45", "house"));
  EXPECT_THAT(facts.streets, ElementsAre("Karlstrasse"));
  EXPECT_THAT(facts.place_classes, Contains(Lares("Kitchen")));
}

TEST(PlaceFactsTest, ANeighbourOnTheSameStoreyIsNotThisPlace) {
  const PlaceFacts facts = ReadMap(std::string(kAddress) +
                                   ":level lares:properPhysicalParts :next .\n"
                                   ":next a lares:Kitchen ; lares:roomNumber \"3002\" .\n"
                                   ":other a lares:Building ; lares:streetNumber \"99\" .\n")
                               .facts;
  EXPECT_THAT(facts.room_numbers, ElementsAre("3001"));
  EXPECT_THAT(facts.buildings, Not(Contains("99")));
  EXPECT_THAT(facts.place_classes, Not(Contains(Lares("Kitchen"))));
}

TEST(PlaceFactsTest, AFlatHoldsItsRoomsAndWhatIsInThem) {
  const PlaceFacts facts =
      ReadMap(
          ":flat a lares:Apartment ; lares:describedInMap :map ; "
          "lares:properPhysicalParts :kitchen , :bath .\n"
          ":kitchen a lares:Kitchen ; lares:roomNumber \"1\" ; lares:describedInMap :map ; "
          "lares:properPhysicalParts :cup .\n"
          ":bath a lares:Bathroom ; lares:roomNumber \"2\" ; lares:describedInMap :map .\n"
          ":cup a lares:Cup .\n")
          .facts;
  EXPECT_THAT(facts.room_numbers, ElementsAre("1", "2"));
  EXPECT_THAT(facts.place_classes,
              AllOf(Contains(Lares("Apartment")), Not(Contains(Lares("Kitchen")))));
  EXPECT_THAT(facts.held_classes,
              AllOf(IsSupersetOf({Lares("Kitchen"), Lares("Bathroom"), Lares("Cup"),
                                  Lares("Container"), Lares("PhysicalObject")}),
                    Not(Contains(Lares("Apartment")))));
}

TEST(PlaceFactsTest, WithoutAMapTheInnermostPlacesAreMeant) {
  const PlaceFacts facts = ReadMap(
                               ":level a lares:Storey ; lares:floorNumber \"2\" ; "
                               "lares:properPhysicalParts :room .\n"
                               ":room a lares:Office ; lares:roomNumber \"B5\" .\n")
                               .facts;
  EXPECT_THAT(facts.room_numbers, ElementsAre("B5"));
  EXPECT_THAT(facts.levels, ElementsAre("2"));
  EXPECT_THAT(facts.place_classes, Contains(Lares("Office")));
  EXPECT_THAT(facts.place_classes, Not(Contains(Lares("Storey"))));
}

TEST(PlaceFactsTest, NothingIsSaidOfAPlace) {
  const PlaceFacts facts = ReadMap(":cup a lares:Cup ; lares:describedInMap :map .").facts;
  EXPECT_THAT(facts.room_numbers, IsEmpty());
  EXPECT_THAT(facts.place_classes, IsEmpty());
  EXPECT_THAT(facts.held_classes, Contains(Lares("Cup")));
  EXPECT_THAT(ReadPlaceFacts(rdf::View(std::make_shared<rdf::Dictionary>()), {}).streets,
              IsEmpty());
}

// --- What belongs where ------------------------------------------------------------------------

TEST(BelongingTest, APartOfAPartOfARoomIsInTheRoom) {
  const Read read = ReadMap(std::string(kAddress) +
                            ":room lares:properPhysicalParts :cabinet .\n"
                            ":cabinet a lares:Cabinet ; lares:properPhysicalParts :door .\n"
                            ":door a lares:Door ; lares:properPhysicalParts :handle .\n"
                            ":handle a lares:Handle .\n");
  const std::string room = lares::testing::Example("room");
  for (const char* part : {"cabinet", "door", "handle"}) {
    EXPECT_EQ(read.Named(part).room, room) << part;
    EXPECT_THAT(read.Named(part).maps, ElementsAre(lares::testing::Example("map"))) << part;
  }
  EXPECT_EQ(read.Named("handle").part_of, lares::testing::Example("door"));
  EXPECT_EQ(read.Named("door").part_of, lares::testing::Example("cabinet"));
  EXPECT_EQ(read.Named("cabinet").part_of, room);
  EXPECT_EQ(read.Named("room").room, "");
  EXPECT_EQ(read.objects.size(), 4U);  // neither storey nor building are objects of the map
}

TEST(BelongingTest, WhatIsOnlyDescribedBelongsToTheMap) {
  const Read read =
      ReadMap(std::string(kAddress) + ":cup a lares:Cup ; lares:describedInMap :map .");
  EXPECT_EQ(read.Named("cup").room, "");
  EXPECT_EQ(read.Named("cup").part_of, "");
  EXPECT_THAT(read.Named("cup").maps, ElementsAre(lares::testing::Example("map")));
}

TEST(BelongingTest, InsideRoomAndItsInverseCountToo) {
  const Read read = ReadMap(
      ":kitchen a lares:Kitchen . :cup a lares:Cup ; "
      "lares:describedInMap :map ; lares:insideRoom :kitchen .\n"
      ":lid a lares:Cup ; lares:describedInMap :map ; "
      "lares:properPhysicalPartOf :kitchen .");
  EXPECT_EQ(read.Named("cup").room, lares::testing::Example("kitchen"));
  EXPECT_EQ(read.Named("lid").room, lares::testing::Example("kitchen"));
}

TEST(BelongingTest, CirclesOfPartsEnd) {
  const Read read = ReadMap(
      ":a a lares:Cabinet ; lares:describedInMap :map ; "
      "lares:properPhysicalParts :b . :b a lares:Door ; "
      "lares:properPhysicalParts :a .");
  EXPECT_EQ(read.objects.size(), 2U);
  EXPECT_EQ(read.Named("a").part_of, lares::testing::Example("b"));
  EXPECT_EQ(read.Named("a").room, "");
}

TEST(BelongingTest, APartWithoutAClassIsNoObject) {
  const Read read = ReadMap(
      ":door a lares:Door ; lares:describedInMap :map ; "
      "lares:properPhysicalParts :hinge .");
  EXPECT_EQ(read.objects.size(), 1U);
}

TEST(BelongingTest, LongChainsAreFollowedAsFarAsTheyMatter) {
  std::string text = ":p0 a lares:Cabinet ; lares:describedInMap :map .\n";
  for (int i = 0; i < 150; ++i) {
    text += ":p" + std::to_string(i) + " lares:properPhysicalParts :p" + std::to_string(i + 1) +
            " . :p" + std::to_string(i + 1) + " a lares:Door .\n";
  }
  const Read read = ReadMap(text);
  EXPECT_EQ(read.objects.size(), 151U);
  EXPECT_EQ(read.Named("p150").part_of, lares::testing::Example("p149"));
}

// --- RoboEarth's maps --------------------------------------------------------------------------

TEST(RecordedPlacesTest, EveryHospitalRoomIsFoundByItsAddress) {
  LARES_REQUIRE_DATA(maps, "roboearth/maps");
  for (const char* name :
       {"map_hospital_room.owl", "ias_hospital_room.owl", "ias_hospital_room_with_objects.owl",
        "ias_hospital_room_octomap.owl", "ias_hospital_room_2D_occupancy_map.owl",
        "ias_hospital_room_vslam_map.owl"}) {
    const PlaceFacts facts = ReadFile(maps / name).facts;
    EXPECT_THAT(facts.room_numbers, ElementsAre("3001")) << name;
    EXPECT_THAT(facts.levels, ElementsAre("3")) << name;
    EXPECT_THAT(facts.buildings, ElementsAre("45", "Building4268")) << name;
    EXPECT_THAT(facts.streets, ElementsAre("Karlstrasse")) << name;
    EXPECT_THAT(facts.cities, ElementsAre("Muenchen", "Munich")) << name;
    EXPECT_THAT(facts.place_classes,
                AllOf(Contains(Lares("Room")), Not(Contains(Lares("Building")))))
        << name;
  }
  const PlaceFacts early = ReadFile(maps / "map_hospital_room.owl").facts;
  EXPECT_THAT(early.place_classes, Contains(Lares("HospitalRoom")));
  EXPECT_THAT(early.held_classes, IsSupersetOf({Lares("Bed"), Lares("DrinkingBottle"),
                                                Lares("Bottle"), Lares("Furniture")}));
  EXPECT_THAT(ReadFile(maps / "ias_hospital_room_octomap.owl").facts.map_classes,
              Contains(Lares("OctoMap")));
}

TEST(RecordedPlacesTest, DoorsAndHandlesOfTheRoomWithObjectsArePartsOfTheCabinet) {
  LARES_REQUIRE_DATA(file, "roboearth/maps/ias_hospital_room_with_objects.owl");
  const Read read = ReadFile(file);
  EXPECT_EQ(LocalName(read.Named("door1").part_of), "cabinet1");
  EXPECT_EQ(LocalName(read.Named("door_handle").part_of), "door1");
  EXPECT_EQ(LocalName(read.Named("box1").part_of), "cabinet1");
  for (const MapObject& object : read.objects) {
    EXPECT_EQ(object.maps.size(), 1U) << object.iri;
  }
  EXPECT_EQ(read.Named("door_handle").maps, read.Named("cabinet1").maps);
}

}  // namespace
}  // namespace lares::semantic
