#include "mapping/environment/layer_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::environment {
namespace {

using ::testing::HasSubstr;

class LayerFormatTest : public ::testing::Test {
 protected:
  ~LayerFormatTest() override { std::filesystem::remove_all(folder_); }

  LayerFacts Check(std::string_view layer, const std::string& bytes, const std::string& name) {
    WriteFileAtomically(folder_ / "blob", bytes);
    return CheckLayer(layer, folder_ / "blob", name);
  }
  std::string Refused(std::string_view layer, const std::string& bytes,
                      const std::string& name = "file") {
    try {
      Check(layer, bytes, name);
    } catch (const Error& error) {
      return std::string(ToString(error.code())) + " " + error.FullMessage();
    }
    return "";
  }

  std::filesystem::path folder_ = MakeFolder();

 private:
  static std::filesystem::path MakeFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "layers-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return pattern;
  }
};

TEST_F(LayerFormatTest, EachLayerIsToldByItsMediaType) {
  EXPECT_EQ(Check("octomap", testing::OneVoxelBt(), "a.bt").media_type, "application/x-octomap");
  EXPECT_EQ(Check("trajectory", "1 0 0 0 0 0 0 1\n", "t.txt").media_type, "text/plain");
  EXPECT_EQ(Check("features", "anything", "f.bin").media_type, "application/octet-stream");
  EXPECT_EQ(Check("features", "", "f.bin").media_type, "application/octet-stream");
  EXPECT_EQ(Check("cloud",
                  "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n",
                  "c.ply")
                .media_type,
            "application/ply");
  const std::string yaml =
      "{image: m.pgm, resolution: 1, origin: [0, 0, 0], negate: 0, occupied_thresh: 0.6, "
      "free_thresh: 0.2}";
  EXPECT_EQ(Check("grid", testing::MakeTar({{"m.yaml", yaml}, {"m.pgm", "P5 1 1 99 a"}}), "g.tar")
                .media_type,
            "application/x-tar");
}

TEST_F(LayerFormatTest, SemanticLayerIsRecognisedAsRdf) {
  EXPECT_EQ(Check("semantic", "@prefix : <http://a/> .\n:a :b :c .", "room").media_type,
            "text/turtle");
  EXPECT_EQ(Check("semantic", "<?xml version=\"1.0\"?><rdf:RDF/>", "room.owl").media_type,
            "application/rdf+xml");
  EXPECT_THAT(Refused("semantic", "\x89PNG\r\n\x1A\n", "room.owl"),
              HasSubstr("invalid room.owl: byte 0: not RDF: it looks like a PNG image"));
  EXPECT_THAT(Refused("semantic", "dear diary", "notes"),
              HasSubstr("invalid notes: byte 0: not RDF"));
  EXPECT_THAT(Refused("semantic", "", "room.ttl"), HasSubstr("it is empty"));
}

TEST_F(LayerFormatTest, LayersThatAreNotWhatTheyClaimAreRefusedByWhatTheyLookLike) {
  EXPECT_THAT(Refused("octomap", "\xFF\xD8\xFF"), HasSubstr("it looks like a JPEG image"));
  EXPECT_THAT(Refused("grid", "P5\n1 1 255 a"), HasSubstr("it looks like a PGM image"));
  EXPECT_THAT(Refused("grid", "\x1F\x8B\x08"), HasSubstr("it looks like a gzip archive"));
  EXPECT_THAT(Refused("cloud", testing::OneVoxelBt()), HasSubstr("it looks like an OctoMap"));
  EXPECT_THAT(Refused("trajectory", "%PDF-1.7"), HasSubstr("it looks like a PDF document"));
  EXPECT_THAT(Refused("octomap", "<?xml version='1.0'?>"), HasSubstr("it looks like an XML"));
}

TEST_F(LayerFormatTest, UnknownLayersAndMissingFilesAreToldApart) {
  EXPECT_THAT(Refused("smells", "x"), HasSubstr("unsupported there is no layer 'smells'"));
  EXPECT_TRUE(IsLayerName("octomap"));
  EXPECT_FALSE(IsLayerName("smells"));
  for (const std::string& layer : LayerNames()) {
    try {
      CheckLayer(layer, folder_ / "absent", "absent");
      FAIL() << layer;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kNotFound) << layer;
    }
  }
}

}  // namespace
}  // namespace lares::environment
