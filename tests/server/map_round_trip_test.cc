// RoboEarth's maps in and out: what comes back as RDF/XML says the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/search_path.h"
#include "ontology/rdf/reader.h"
#include "tests/lares_data.h"
#include "tests/ontology/isomorphism.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using semantic::MapObject;

class MapRoundTripTest : public KnowledgeFixture {
 protected:
  static rdf::Document Parse(const std::string& bytes, rdf::Format format) {
    rdf::ReadOptions options;
    options.source = "map";
    options.base_iri = "https://w3id.org/lares/documents/environment/map";
    return rdf::ReadRdf(bytes, format, options);
  }

  // Through RDF/XML, and into another environment.
  void ExpectRoundTrip(const std::string& bytes, const std::string& file_name) {
    const std::string original = "from-" + std::to_string(++count_);
    const std::string copy = "to-" + std::to_string(count_);
    PutMap(original, bytes, file_name);
    const std::string xml = knowledge_->RenderSemantic(original, 1, rdf::Format::kRdfXml);
    PutMap(copy, xml, "copy.owl");
    const rdf::Document before = Parse(bytes, rdf::GuessFormat("", file_name, bytes));
    const rdf::Document after = Parse(xml, rdf::Format::kRdfXml);
    EXPECT_TRUE(rdf::testing::AreIsomorphic(before, after))
        << rdf::testing::Lines(before) << "\nbecame\n"
        << rdf::testing::Lines(after);
    const auto objects = knowledge_->MapObjects(copy, 1);
    EXPECT_FALSE(objects.empty());
    ExpectSameObjects(knowledge_->MapObjects(original, 1), objects);
  }

  int count_ = 0;

  static void ExpectSameObjects(const std::vector<MapObject>& before,
                                const std::vector<MapObject>& after) {
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const MapObject& a = before[i];
      const MapObject& b = after[i];
      EXPECT_EQ(a.iri, b.iri);
      EXPECT_EQ(a.label, b.label);
      EXPECT_EQ(a.class_iri, b.class_iri);
      EXPECT_EQ(a.class_as_written, b.class_as_written);
      EXPECT_EQ(a.first_seen, b.first_seen);
      EXPECT_EQ(a.last_seen, b.last_seen);
      EXPECT_EQ(a.recognised_with, b.recognised_with);
      EXPECT_EQ(a.part_of, b.part_of);
      EXPECT_EQ(a.room, b.room);
      EXPECT_EQ(a.maps, b.maps);
      EXPECT_EQ(a.extent_m, b.extent_m);
      ASSERT_EQ(a.map_from_object.has_value(), b.map_from_object.has_value());
      if (!a.map_from_object) continue;
      EXPECT_EQ(a.map_from_object->translation_m, b.map_from_object->translation_m);
      EXPECT_EQ(a.map_from_object->rotation.coeffs(), b.map_from_object->rotation.coeffs());
    }
  }
};

std::string Matrix(const std::string& name, const std::string& x) {
  std::string text = ":" + name + " a lares:RotationMatrix3D";
  const char* rows[4][4] = {{"0.0", "-1.0", "0.0", ""},
                            {"1.0", "0.0", "0.0", "-2.25"},
                            {"0.0", "0.0", "1.0", "1e-1"},
                            {"0.0", "0.0", "0.0", "1.0"}};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const std::string value = row == 0 && column == 3 ? x : rows[row][column];
      text += " ; lares:m" + std::to_string(row) + std::to_string(column) + " \"" + value +
              "\"^^xsd:double";
    }
  }
  return text + " .\n";
}

TEST_F(MapRoundTripTest, ADocumentOfOurOwnWithAllThatMapsHold) {
  const std::string map =
      std::string(kPrefixes) +
      ":room a lares:HospitalRoom ; lares:roomNumber \"3\u00E9<&>\\\"\" ; "
      "lares:describedInMap :map ; lares:properPhysicalParts :cabinet .\n"
      ":map a lares:SemanticEnvironmentMap ; lares:linkToMapFile \"http://x/?a=1&b=2\" .\n"
      ":cabinet a lares:Cabinet ; rdfs:label \"Schrank\"@de , \"cabinet\"@en ; "
      "lares:depthOfObject \"0.40\"^^xsd:float ; lares:widthOfObject 0.8 ; "
      "lares:heightOfObject \"1.2E0\"^^xsd:double ; lares:properPhysicalParts :door-1 .\n"
      ":door-1 a lares:Door .\n"
      ":seen1 a lares:SemanticMapPerception ; lares:objectActedOn :cabinet ; "
      "lares:eventOccursAt :m1 ; lares:startTime :timepoint_1271159865.00 ; "
      "lares:recognizedUsingModel <https://example.org/models#cabinet?v=2&x> .\n"
      ":seen2 a lares:SemanticMapPerception ; lares:objectActedOn :cabinet ; "
      "lares:eventOccursAt :m2 ; lares:startTime :timepoint_1271159999.50 ; "
      "lares:recognizedUsingModel :newer .\n"
      ":timepoint_1271159865.00 a lares:TimePoint . :timepoint_1271159999.50 a lares:TimePoint .\n"
      ":seen3 a lares:SemanticMapPerception ; lares:objectActedOn :door-1 ; "
      "lares:eventOccursAt [ a lares:RotationMatrix3D ; lares:relativeTo :cabinet ; "
      "lares:m00 1 ; lares:m01 0 ; lares:m02 0 ; lares:m03 0.5 ; lares:m10 0 ; lares:m11 1 ; "
      "lares:m12 0 ; lares:m13 0 ; lares:m20 0 ; lares:m21 0 ; lares:m22 1 ; lares:m23 0 ; "
      "lares:m30 0 ; lares:m31 0 ; lares:m32 0 ; lares:m33 1 ] .\n" +
      Matrix("m1", "1.5") + Matrix("m2", "1.75");
  ExpectRoundTrip(map, "map.ttl");
  const auto objects = knowledge_->MapObjects("to-1", 1);
  const auto cabinet = std::find_if(objects.begin(), objects.end(), [](const MapObject& object) {
    return object.iri == "http://example.org/test#cabinet";
  });
  ASSERT_NE(cabinet, objects.end());
  EXPECT_EQ(cabinet->recognised_with, "http://example.org/test#newer");
  EXPECT_EQ(cabinet->room, "http://example.org/test#room");
  EXPECT_EQ(cabinet->map_from_object->translation_m.x(), 1.75);
  EXPECT_EQ(ToRfc3339(*cabinet->first_seen), "2010-04-13T11:57:45.000Z");
  EXPECT_EQ(ToRfc3339(*cabinet->last_seen), "2010-04-13T11:59:59.500Z");
}

TEST_F(MapRoundTripTest, RoboEarthsMapsComeBackAsTheyWere) {
  LARES_REQUIRE_DATA(maps, "roboearth/maps");
  for (const char* name : {"ias_hospital_room_with_objects.owl", "map_hospital_room.owl",
                           "ias_hospital_room.owl", "environment_map.owl"}) {
    SCOPED_TRACE(name);
    ExpectRoundTrip(ReadFile(maps / name), name);
  }
}

}  // namespace
}  // namespace lares::testing
