// Whole maps, read as they are: the demonstration's own, and some that others made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "mapping/environment/grid_format.h"
#include "mapping/environment/layer_format.h"
#include "mapping/semantic/map_object.h"
#include "ontology/rdf/reader.h"
#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::semantic {
namespace {

using ::testing::UnorderedElementsAre;

rdf::AliasTable Aliases() {
  return rdf::AliasTable::FromTsv(lares::ReadFile(FindShared("ontology/aliases.tsv")),
                                  "aliases.tsv");
}

std::vector<MapObject> ReadFile(const std::filesystem::path& file) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  const std::string bytes = lares::ReadFile(file);
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  std::vector<rdf::Graph> graphs;
  const rdf::Format format = rdf::GuessFormat("", options.source, bytes);
  graphs.push_back(
      rdf::MakeGraph(rdf::ReadRdf(bytes, format, options), "map", Aliases(), *dictionary));
  return ReadMapObjects(
      rdf::View(dictionary)
          .With(std::make_shared<const rdf::Layer>(std::move(graphs), std::vector<rdf::Triple>(),
                                                   std::vector<rdf::Clash>())));
}

std::vector<std::string> Locals(const std::vector<MapObject>& objects) {
  std::vector<std::string> locals;
  for (const MapObject& object : objects) locals.emplace_back(LocalName(object.iri));
  return locals;
}

const MapObject& Named(const std::vector<MapObject>& objects, std::string_view local) {
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const MapObject& object) {
    return LocalName(object.iri) == local;
  });
  if (found == objects.end()) throw std::runtime_error("no object " + std::string(local));
  return *found;
}

TEST(DemonstrationTest, FlatAndItsGridAreOfOnePlace) {
  const std::filesystem::path demo = std::filesystem::path(LARES_SOURCE_DIR) / "demo";
  const std::vector<MapObject> objects = ReadFile(demo / "flat.ttl");
  EXPECT_GT(objects.size(), 10U);
  for (const MapObject& object : objects) {
    const bool is_posed = object.map_from_object && object.extent_m && object.last_seen;
    EXPECT_EQ(is_posed, LocalName(object.class_iri) != "Apartment") << object.iri;
    EXPECT_TRUE(object.remarks.empty()) << object.iri;
  }
  const std::string tar =
      environment::testing::MakeTar({{"flat.yaml", lares::ReadFile(demo / "flat.yaml")},
                                     {"flat.pgm", lares::ReadFile(demo / "flat.pgm")}});
  environment::LayerFacts semantic;
  semantic.bounds_m = BoundsOf(objects);
  const auto grid = environment::CheckGrid(
      [&] { return environment::TarReader::OfBytes(tar, "flat.tar"); }, "flat.tar");
  EXPECT_TRUE(environment::WarnOnExtents({{"grid", grid}, {"semantic", semantic}}).empty());
}

TEST(RecordedMapsTest, HospitalRoomHasItsSixObjectsWithPoses) {
  LARES_REQUIRE_DATA(file, "roboearth/maps/ias_hospital_room.owl");
  const std::vector<MapObject> objects = ReadFile(file);
  EXPECT_THAT(Locals(objects), UnorderedElementsAre("bed1", "bottle1", "cabinet1", "door1",
                                                    "door_handle", "Room7635"));
  for (const MapObject& object : objects) EXPECT_TRUE(object.map_from_object) << object.iri;
  const MapObject& bed = Named(objects, "bed1");
  EXPECT_EQ(bed.class_iri, "https://w3id.org/lares#Bed");
  EXPECT_EQ(bed.class_as_written, "http://ias.cs.tum.edu/kb/knowrob.owl#Bed-PieceOfFurniture");
  EXPECT_TRUE(
      bed.map_from_object->translation_m.isApprox(Eigen::Vector3d(0.729698, -3.32831, 0.35), 1e-9));
  EXPECT_TRUE(bed.extent_m->isApprox(Eigen::Vector3d(2.0, 0.92, 0.7), 1e-9));
  EXPECT_EQ(ToRfc3339(*bed.last_seen), "2011-11-17T14:41:51.000Z");
  EXPECT_FALSE(Named(objects, "bottle1").extent_m);
  EXPECT_NEAR(YawRad(*Named(objects, "cabinet1").map_from_object), -1.4948, 1e-4);
}

TEST(RecordedMapsTest, CorridorOctomapIsTooLargeForTheHospitalRoom) {
  LARES_REQUIRE_DATA(room, "roboearth/maps/ias_hospital_room.owl");
  LARES_REQUIRE_DATA(octomap, "octomap/geb079.bt");
  environment::LayerFacts semantic;
  semantic.bounds_m = BoundsOf(ReadFile(room));
  ASSERT_TRUE(semantic.bounds_m);
  const auto facts = environment::CheckLayer("octomap", octomap, "geb079.bt");
  EXPECT_EQ(environment::WarnOnExtents({{"octomap", facts}, {"semantic", semantic}}).size(), 1U);
}

TEST(RecordedMapsTest, RoomWithObjectsHoldsTwentyThreePosedObjects) {
  LARES_REQUIRE_DATA(file, "roboearth/maps/ias_hospital_room_with_objects.owl");
  const std::vector<MapObject> objects = ReadFile(file);
  EXPECT_EQ(
      std::count_if(objects.begin(), objects.end(),
                    [](const MapObject& object) { return object.map_from_object.has_value(); }),
      23);
  EXPECT_FALSE(Named(objects, "bottle1").extent_m);  // written as 0 × 0 × 0
}

TEST(RecordedMapsTest, EarlyHospitalRoomIsRead) {
  LARES_REQUIRE_DATA(file, "roboearth/maps/map_hospital_room.owl");
  const std::vector<MapObject> objects = ReadFile(file);
  EXPECT_THAT(Locals(objects),
              UnorderedElementsAre("bed1", "bottle1", "cabinet1", "cabinet2", "door1", "Room7635"));
  EXPECT_FALSE(Named(objects, "Room7635").map_from_object);
}

TEST(RecordedMapsTest, KitchenIsReadWithItsMirroredHinges) {
  LARES_REQUIRE_DATA(file, "roboearth/maps/environment_map.owl");
  const std::vector<MapObject> objects = ReadFile(file);
  EXPECT_EQ(objects.size(), 88U);  // 89 perceptions, one of them of the map itself
  int mirrored = 0;
  for (const MapObject& object : objects) {
    EXPECT_TRUE(object.map_from_object) << object.iri;
    if (object.remarks.empty()) continue;
    ++mirrored;
    EXPECT_EQ(LocalName(object.class_iri), "Hinge") << object.iri;
  }
  EXPECT_EQ(mirrored, 14);
}

TEST(RecordedMapsTest, MapsOfOtherLayersDescribeTheRoomWithoutPose) {
  LARES_REQUIRE_DATA(folder, "roboearth/maps");
  for (const char* name : {"ias_hospital_room_2D_occupancy_map.owl",
                           "ias_hospital_room_octomap.owl", "ias_hospital_room_vslam_map.owl"}) {
    EXPECT_THAT(Locals(ReadFile(folder / name)), UnorderedElementsAre("Room7635")) << name;
  }
}

}  // namespace
}  // namespace lares::semantic
