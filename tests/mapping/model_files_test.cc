// The files of object models: what they say of the object's size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "mapping/objects/extents.h"
#include "tests/lares_data.h"

namespace lares::objects {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string Planar(const std::string& dimensions, const std::string& type = "planar") {
  return "<model>\n<name>crate</name>\n<type>" + type +
         "</type>\n<faces>1</faces>\n<dimensions>\n" + dimensions + "\n</dimensions>\n</model>\n";
}

const char kSize[] = "<width>0.4</width><height>0.3</height><depth>0.6</depth>";

std::string Refused(const std::string& text) {
  try {
    ReadModelMeta(text, "meta.xml");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    return error.FullMessage();
  }
  ADD_FAILURE() << "was taken: " << text;
  return "";
}

TEST(ModelMetaTest, PlanarModelsStateTheirSize) {
  const ModelMeta meta =
      ReadModelMeta(Planar(std::string(kSize) + "<face><index>0</index><width>9</width></face>"
                                                "<face><index>1</index><width>8</width></face>"),
                    "meta.xml");
  EXPECT_EQ(meta.name, "crate");
  EXPECT_EQ(meta.kind, "planar");
  EXPECT_EQ(meta.faces, 1U);
  ASSERT_TRUE(meta.size);
  EXPECT_EQ(meta.size->width_m, 0.4);
  EXPECT_EQ(meta.size->height_m, 0.3);
  EXPECT_EQ(meta.size->depth_m, 0.6);
}

TEST(ModelMetaTest, SolidModelsStateTheirScale) {
  const ModelMeta meta = ReadModelMeta(Planar("<scale>0.5</scale>", "3D"), "meta.xml");
  EXPECT_FALSE(meta.size);
  EXPECT_EQ(meta.scale, 0.5);
}

TEST(ModelMetaTest, FaultsNameLineAndElement) {
  EXPECT_THAT(Refused(Planar("<width>wide</width><height>1</height><depth>1</depth>")),
              ::testing::AllOf(HasSubstr("meta.xml:6"), HasSubstr("'wide' is not a number")));
  EXPECT_THAT(Refused(Planar("<width>nan</width><height>1</height><depth>1</depth>")),
              HasSubstr("not a number"));
  EXPECT_THAT(Refused(Planar("<width>-1</width><height>1</height><depth>1</depth>")),
              HasSubstr("not above 0"));
  EXPECT_THAT(Refused(Planar("<width>1</width><height>1e9</height><depth>1</depth>")),
              HasSubstr("at most 1000 m"));
  EXPECT_THAT(Refused(Planar("<width>1</width><width>1</width>")), HasSubstr("twice"));
  EXPECT_THAT(Refused(Planar("<width>1</width>")), HasSubstr("dimensions/height> is missing"));
  EXPECT_THAT(Refused(Planar(kSize, "round")), HasSubstr("'round' is no kind of model"));
  EXPECT_THAT(Refused("<model><name>a</name>"), HasSubstr("never closed"));
  EXPECT_THAT(Refused("<model></name></model>"), HasSubstr("closes nothing"));
  EXPECT_THAT(Refused("<model/><model/>"), HasSubstr("second root"));
  EXPECT_THAT(Refused("<other/>"), HasSubstr("not <model>"));
  EXPECT_THAT(Refused(""), HasSubstr("no <model>"));
  EXPECT_THAT(Refused("<!DOCTYPE m [<!ENTITY a \"b\">]><model/>"), HasSubstr("entity"));
  EXPECT_THAT(Refused("<model>\xFF</model>"), HasSubstr("UTF-8"));
  std::string deep = "<model>";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_THAT(Refused(deep), HasSubstr("too deeply"));
}

TEST(ModelMetaTest, OtherXmlIsNone) {
  EXPECT_TRUE(IsModelMeta("<?xml version='1.0'?><!-- by hand --><model>"));
  EXPECT_FALSE(IsModelMeta("<launch><model/></launch>"));
  EXPECT_FALSE(IsModelMeta("model"));
  EXPECT_FALSE(IsModelMeta(""));
}

class ModelFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "lares-model-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  NamedFacts Read(const std::string& name, const std::string& bytes) {
    WriteFileAtomically(folder_ / "blob", bytes);
    return {name, ReadModelFile(folder_ / "blob", name)};
  }
  static std::string Ply(const std::vector<std::string>& points) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    for (const std::string& point : points) text += point + "\n";
    return text;
  }

  std::filesystem::path folder_;
};

TEST_F(ModelFileTest, CloudsGiveTheBoxAroundTheirPoints) {
  const auto cloud = Read("shape.PLY", Ply({"0 -1 2", "0.5 1 2.25"}));
  EXPECT_EQ(cloud.facts.points, 2U);
  const auto extents = FindExtents({cloud, Read("a.png", "no picture")});
  ASSERT_TRUE(extents);
  EXPECT_THAT(extents->size_m, ElementsAre(0.5, 2, 0.25));
  EXPECT_FALSE(extents->axes_known);
  EXPECT_EQ(extents->from, "the points of shape.PLY");
}

TEST_F(ModelFileTest, TheStatedSizeComesBeforeThePoints) {
  const auto extents =
      FindExtents({Read("face.ply", Ply({"0 0 -1", "1 1 -1"})), Read("meta.xml", Planar(kSize))});
  ASSERT_TRUE(extents);
  EXPECT_THAT(extents->size_m, ElementsAre(0.4, 0.3, 0.6));
  EXPECT_TRUE(extents->axes_known);
  EXPECT_EQ(extents->from, "meta.xml");
}

TEST_F(ModelFileTest, FacesOfOneSolidModelAreOfOneFrameAndScaled) {
  const auto a = Read("a.ply", Ply({"0 0 0", "1 1 1"}));
  const auto b = Read("b.ply", Ply({"-1 0 0"}));
  const auto none = Read("c.ply", Ply({}));
  const auto meta = Read("meta.xml", Planar("<scale>0.5</scale>", "3D"));
  EXPECT_THAT(FindExtents({a, b, none, meta})->size_m, ElementsAre(1, 0.5, 0.5));
  EXPECT_FALSE(FindExtents({a, b}));  // nothing says that they share a frame
  EXPECT_THAT(FindExtents({a, none})->size_m, ElementsAre(1, 1, 1));
  EXPECT_FALSE(FindExtents({none, meta}));
  EXPECT_FALSE(FindExtents({}));
}

TEST_F(ModelFileTest, FaultyFilesAreRefusedByName) {
  try {
    Read("face.ply", "ply of nothing");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    EXPECT_THAT(error.FullMessage(), HasSubstr("face.ply"));
  }
  EXPECT_THROW(Read("meta.xml", "<model>"), Error);
  EXPECT_FALSE(Read("robot.xml", "<robot>").facts.meta);
}

std::vector<NamedFacts> ReadFolder(const std::filesystem::path& folder) {
  std::vector<NamedFacts> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    files.push_back({name, ReadModelFile(entry.path(), name)});
  }
  return files;
}

TEST(RecordedModelsTest, SizesOfTheModelsOfRoboEarth) {
  LARES_REQUIRE_DATA(objects, "objects");
  const auto sized = [&](const char* name) { return FindExtents(ReadFolder(objects / name)); };
  EXPECT_THAT(sized("bed1")->size_m, ElementsAre(0.68, 0.28, 2));
  EXPECT_THAT(sized("cabinet1")->size_m, ElementsAre(0.68, 0.68, 0.34));
  EXPECT_THAT(sized("bottle1")->size_m, ElementsAre(0.05, 0.126, 0.049));
  EXPECT_THAT(sized("bottle1_small")->size_m, ElementsAre(0.05, 0.126, 0.049));
  const auto van = sized("van");
  ASSERT_TRUE(van);
  EXPECT_FALSE(van->axes_known);
  for (const double side_m : van->size_m) EXPECT_GT(side_m, 0.1);
  const auto box = sized("cookies-box");
  ASSERT_TRUE(box);
  EXPECT_THAT(box->size_m[1], DoubleNear(25.8, 1e-5));
}

}  // namespace
}  // namespace lares::objects
