#include "mapping/environment/octomap_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <random>
#include <sstream>

#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::environment {
namespace {

using testing::Check;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::OneVoxelBt;
using testing::Refusal;
using testing::TwoLeavesOt;

std::string Refused(const std::string& bytes) { return Refusal(CheckOctomap, bytes); }

// The box of all occupied leaves, as OctoMap's own tree has them.
template <typename Tree>
std::array<double, 6> OccupiedBounds(const Tree& tree) {
  std::array<double, 6> bounds = {1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const double centre[3] = {leaf.getX(), leaf.getY(), leaf.getZ()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds[axis] = std::min(bounds[axis], centre[axis] - leaf.getSize() / 2);
      bounds[axis + 3] = std::max(bounds[axis + 3], centre[axis] + leaf.getSize() / 2);
    }
  }
  return bounds;
}

template <typename Tree>
void ExpectAgrees(const LayerFacts& facts, const Tree& tree) {
  EXPECT_EQ(facts.facts.at("nodes"), std::to_string(tree.size()));
  std::size_t occupied = 0, free = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    ++(tree.isNodeOccupied(*leaf) ? occupied : free);
  }
  EXPECT_EQ(facts.facts.at("occupied_leaves"), std::to_string(occupied));
  EXPECT_EQ(facts.facts.at("free_leaves"), std::to_string(free));
  ASSERT_TRUE(facts.bounds_m);
  const auto bounds = OccupiedBounds(tree);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR((*facts.bounds_m)[i], bounds[i], 1e-6) << i;
}

template <typename Tree>
void AddRandomVoxels(Tree& tree, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate_m(-4, 7);
  for (int i = 0; i < 500; ++i) {
    tree.updateNode(octomap::point3d(coordinate_m(random), coordinate_m(random) / 2, 1),
                    i % 3 == 0);
  }
}

TEST(OctomapFormatTest, OneVoxelIsCountedAndPlaced) {
  const LayerFacts facts = Check(CheckOctomap, OneVoxelBt());
  EXPECT_EQ(facts.facts.at("nodes"), "17");
  EXPECT_EQ(facts.facts.at("occupied_leaves"), "1");
  EXPECT_EQ(facts.facts.at("resolution_m"), "0.5");
  EXPECT_THAT(*facts.bounds_m, ElementsAre(0, 0, 0, 0.5, 0.5, 0.5));
}

TEST(OctomapFormatTest, FullFormatTellsFreeFromOccupied) {
  const LayerFacts facts = Check(CheckOctomap, TwoLeavesOt());
  EXPECT_EQ(facts.facts.at("free_leaves"), "1");
  EXPECT_EQ(facts.facts.at("occupied_leaves"), "1");
  EXPECT_THAT(*facts.bounds_m, ElementsAre(0, 0, 0, DoubleNear(3276.8, 1e-9),
                                           DoubleNear(3276.8, 1e-9), DoubleNear(3276.8, 1e-9)));
}

TEST(OctomapFormatTest, ColoursAreReadPast) {
  const LayerFacts facts = Check(CheckOctomap, TwoLeavesOt("ColorOcTree", 0.85F, "\xFF\x80\x01"));
  EXPECT_EQ(facts.facts.at("tree"), "ColorOcTree");
}

TEST(OctomapFormatTest, EmptyTreeHasNoBounds) {
  const LayerFacts facts =
      Check(CheckOctomap, "# Octomap OcTree binary file\nid OcTree\nsize 0\nres 0.1\ndata\n");
  EXPECT_FALSE(facts.bounds_m);
}

TEST(OctomapFormatTest, AgreesWithOctomapOnRandomTreesInBothFormats) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    octomap::OcTree tree(0.05);
    AddRandomVoxels(tree, seed);
    std::stringstream full;
    tree.write(full);
    ExpectAgrees(Check(CheckOctomap, full.str()), tree);
    tree.toMaxLikelihood();
    tree.prune();
    std::stringstream binary;
    tree.writeBinaryConst(binary);
    ExpectAgrees(Check(CheckOctomap, binary.str()), tree);
  }
}

TEST(OctomapFormatTest, AgreesWithOctomapOnColouredTrees) {
  octomap::ColorOcTree tree(0.1);
  AddRandomVoxels(tree, 7);
  std::stringstream full;
  tree.write(full);
  ExpectAgrees(Check(CheckOctomap, full.str()), tree);
}

TEST(OctomapFormatTest, AgreesWithOctomapOnRecordedMaps) {
  LARES_REQUIRE_DATA(folder, "octomap");
  for (const char* name : {"geb079.bt", "slambook_octomap.bt"}) {
    ByteReader reader = ByteReader::OfFile(folder / name, name);
    octomap::OcTree tree(0.1);
    ASSERT_TRUE(tree.readBinary((folder / name).string()));
    ExpectAgrees(CheckOctomap(reader), tree);
  }
}

TEST(OctomapFormatTest, RecordedCorridorIsThirtyNineMetresLong) {
  LARES_REQUIRE_DATA(file, "octomap/geb079.bt");
  ByteReader reader = ByteReader::OfFile(file, "geb079.bt");
  const LayerFacts facts = CheckOctomap(reader);
  EXPECT_EQ(facts.facts.at("nodes"), "532566");
  EXPECT_EQ(facts.facts.at("resolution_m"), "0.08");
  const auto& bounds = *facts.bounds_m;
  EXPECT_NEAR(bounds[3] - bounds[0], 39, 1);
  EXPECT_NEAR(bounds[4] - bounds[1], 15, 1);
  EXPECT_NEAR(bounds[5] - bounds[2], 3, 1);
}

TEST(OctomapFormatTest, CutOffFileNamesTheByte) {
  const std::string whole = OneVoxelBt();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THAT(Refused(whole.substr(0, size)), HasSubstr("file: byte ")) << size;
  }
  EXPECT_THAT(
      Refused(whole.substr(0, whole.size() - 1)),
      HasSubstr("byte " + std::to_string(whole.size() - 1) + ": the file ends in node 16 of 17"));
}

TEST(OctomapFormatTest, WrongSizesAreRefused) {
  EXPECT_THAT(Refused(OneVoxelBt("0.5", "16")), HasSubstr("more nodes than the 16"));
  EXPECT_THAT(Refused(OneVoxelBt("0.5", "18")),
              HasSubstr("the tree has 17 nodes, the header says 18"));
  EXPECT_THAT(Refused(OneVoxelBt("0.5", "18446744073709551615")), HasSubstr("17 nodes"));
  EXPECT_THAT(Refused(OneVoxelBt("0.5", "99999999999999999999999")), HasSubstr("not a number"));
  EXPECT_THAT(Refused(OneVoxelBt("0.5", "-1")), HasSubstr("not a number"));
}

TEST(OctomapFormatTest, WrongResolutionsAreRefused) {
  for (const char* resolution : {"0", "-0.1", "nan", "inf", "1e300"}) {
    EXPECT_THAT(Refused(OneVoxelBt(resolution)), HasSubstr("resolution")) << resolution;
  }
  EXPECT_THAT(Refused(OneVoxelBt("wide")), HasSubstr("'res' is not a number: 'wide'"));
}

TEST(OctomapFormatTest, NodesBelowTheSixteenthLevelAreRefused) {
  std::string bytes = OneVoxelBt("0.5", "18");
  bytes[bytes.size() - 2] = '\x03';
  EXPECT_THAT(Refused(bytes + std::string("\x02\x00", 2)), HasSubstr("below the 16th level"));
}

TEST(OctomapFormatTest, InnerNodeWithoutChildrenIsRefused) {
  std::string bytes = OneVoxelBt();
  bytes[bytes.size() - 2] = '\x00';
  EXPECT_THAT(Refused(bytes), HasSubstr("has no children"));
}

TEST(OctomapFormatTest, BytesAfterTheTreeAreRefused) {
  EXPECT_THAT(Refused(OneVoxelBt() + "x"), HasSubstr("bytes follow the last node"));
}

TEST(OctomapFormatTest, LogOddsThatAreNoNumberAreRefused) {
  EXPECT_THAT(Refused(TwoLeavesOt("OcTree", std::numeric_limits<float>::quiet_NaN())),
              HasSubstr("log-odds"));
  EXPECT_THAT(Refused(TwoLeavesOt("OcTree", std::numeric_limits<float>::infinity())),
              HasSubstr("log-odds"));
}

TEST(OctomapFormatTest, UnknownTreeClassIsNamed) {
  EXPECT_THAT(Refused(TwoLeavesOt("CountingOcTree")), HasSubstr("'CountingOcTree' is not known"));
}

TEST(OctomapFormatTest, OtherFilesAreRefusedByWhatTheyLookLike) {
  EXPECT_THAT(Refused("\x89PNG\r\n\x1A\n...."), HasSubstr("it looks like a PNG image"));
  EXPECT_THAT(Refused(""), HasSubstr("it is empty"));
  EXPECT_THAT(Refused("hello"), HasSubstr("not an OctoMap file"));
}

TEST(OctomapFormatTest, EndlessHeaderIsRefused) {
  EXPECT_THAT(Refused("# Octomap OcTree binary file\n" + std::string(5000, 'x')),
              HasSubstr("longer than"));
  std::string many = "# Octomap OcTree binary file\n";
  for (int i = 0; i < 1000; ++i) many += "# more\n";
  EXPECT_THAT(Refused(many), HasSubstr("no 'data' line"));
}

}  // namespace
}  // namespace lares::environment
