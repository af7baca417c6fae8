#include "mapping/environment/grid_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mapping/layer_bytes.h"

namespace lares::environment {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MakeTar;
using testing::TarFile;

constexpr char kYaml[] =
    "image: map.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

// Three columns and two rows: occupied, unknown, free; free, free, free.
std::string Pgm() { return "P5\n# test\n3 2\n255\n" + std::string("\x00\xCD\xFE\xFE\xFE\xFE", 6); }

LayerFacts CheckTar(const std::string& tar) {
  return CheckGrid([&] { return TarReader::OfBytes(tar, "grid.tar"); }, "grid.tar");
}

std::string Refused(const std::string& tar) {
  try {
    CheckTar(tar);
  } catch (const Error& error) {
    return error.code() == Code::kInvalid ? error.FullMessage() : "not kInvalid";
  }
  return "";
}

std::string RefusedYaml(const std::string& yaml) {
  return Refused(MakeTar({{"map.yaml", yaml}, {"map.pgm", Pgm()}}));
}

// kYaml with the line of `key` replaced, or left out for an empty line.
std::string YamlWith(const std::string& key, const std::string& line) {
  std::string yaml = kYaml;
  const std::size_t start = yaml.find(key + ":");
  const std::size_t end = yaml.find('\n', start) + 1;
  return yaml.replace(start, end - start, line.empty() ? "" : line + "\n");
}

TEST(GridFormatTest, MapServerPairIsMeasured) {
  const LayerFacts facts = CheckTar(MakeTar({{"map.yaml", kYaml}, {"map.pgm", Pgm()}}));
  EXPECT_EQ(facts.facts.at("width_px"), "3");
  EXPECT_EQ(facts.facts.at("height_px"), "2");
  EXPECT_EQ(facts.facts.at("resolution_m"), "0.5");
  EXPECT_EQ(facts.facts.at("occupied_cells"), "1");
  EXPECT_EQ(facts.facts.at("free_cells"), "4");
  EXPECT_THAT(*facts.bounds_m, ElementsAre(-1, 2, 0, 0.5, 3, 0));
}

TEST(GridFormatTest, OrderFoldersAndCompanionsDoNotMatter) {
  EXPECT_EQ(Refused(MakeTar({{"./", "", AE_IFDIR},
                             {"./maps/._map.yaml", "junk"},
                             {"./maps/map.pgm", Pgm()},
                             {"./maps/map.yaml", YamlWith("image", "image: ./map.pgm")}})),
            "");
}

TEST(GridFormatTest, YawTurnsTheBounds) {
  const std::string yaml = YamlWith("origin", "origin: [0, 0, 1.5707963267948966]");
  const LayerFacts facts = CheckTar(MakeTar({{"map.yaml", yaml}, {"map.pgm", Pgm()}}));
  EXPECT_THAT(*facts.bounds_m, ElementsAre(DoubleNear(-1, 1e-9), DoubleNear(0, 1e-9), 0,
                                           DoubleNear(0, 1e-9), DoubleNear(1.5, 1e-9), 0));
}

TEST(GridFormatTest, NegateSwapsOccupiedAndFree) {
  const std::string yaml = YamlWith("negate", "negate: true");
  const LayerFacts facts = CheckTar(MakeTar({{"map.yaml", yaml}, {"map.pgm", Pgm()}}));
  EXPECT_EQ(facts.facts.at("occupied_cells"), "5");
  EXPECT_EQ(facts.facts.at("free_cells"), "1");
}

TEST(GridFormatTest, TextImagesAndDeepGreyAreRead) {
  EXPECT_EQ(Refused(MakeTar({{"map.yaml", kYaml}, {"map.pgm", "P2 # t\n2 1\n100\n0 100\n"}})), "");
  EXPECT_EQ(Refused(MakeTar({{"map.yaml", kYaml}, {"map.pgm", "P5 1 1 65535 ab"}})), "");
}

TEST(GridFormatTest, EveryYamlKeyIsChecked) {
  for (const char* key :
       {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    EXPECT_THAT(RefusedYaml(YamlWith(key, "")), HasSubstr(std::string("'") + key + "' is missing"));
  }
  EXPECT_THAT(RefusedYaml(YamlWith("resolution", "resolution: 0")),
              HasSubstr("grid.tar/map.yaml:2:13: 'resolution' must be more than 0"));
  EXPECT_THAT(RefusedYaml(YamlWith("resolution", "resolution: .nan")), HasSubstr("finite"));
  EXPECT_THAT(RefusedYaml(YamlWith("resolution", "resolution: nan")), HasSubstr("finite"));
  EXPECT_THAT(RefusedYaml(YamlWith("origin", "origin: [0, 0]")), HasSubstr("three numbers"));
  EXPECT_THAT(RefusedYaml(YamlWith("origin", "origin: [0, 0, inf]")), HasSubstr("finite"));
  EXPECT_THAT(RefusedYaml(YamlWith("origin", "origin: [0, 0, {a: b}]")), HasSubstr("finite"));
  EXPECT_THAT(RefusedYaml(YamlWith("negate", "negate: 2")), HasSubstr("neither 0 nor 1"));
  EXPECT_THAT(RefusedYaml(YamlWith("occupied_thresh", "occupied_thresh: 1.5")),
              HasSubstr("more than 1"));
  EXPECT_THAT(RefusedYaml(YamlWith("free_thresh", "free_thresh: 0.9")),
              HasSubstr("less than occupied_thresh"));
  EXPECT_THAT(RefusedYaml(std::string(kYaml) + "mode: fancy\n"),
              HasSubstr("trinary, scale and raw"));
  EXPECT_EQ(RefusedYaml(std::string(kYaml) + "mode: scale\nowner: me\n"), "");
}

TEST(GridFormatTest, WhatIsNoYamlIsRefusedWithItsPlace) {
  EXPECT_THAT(RefusedYaml("image: [map.pgm\n"), HasSubstr("grid.tar/map.yaml:"));
  EXPECT_THAT(RefusedYaml("just text"), HasSubstr("no 'key: value' lines"));
  EXPECT_THAT(RefusedYaml(""), HasSubstr("no 'key: value' lines"));
  EXPECT_THAT(RefusedYaml(std::string(8000, '[')), HasSubstr("not YAML"));
  EXPECT_THAT(RefusedYaml("# " + std::string(20'000, 'x')), HasSubstr("larger than 16 KiB"));
}

TEST(GridFormatTest, ImagesOutsideTheArchiveAreRefused) {
  EXPECT_THAT(RefusedYaml(YamlWith("image", "image: /etc/passwd")), HasSubstr("outside"));
  EXPECT_THAT(RefusedYaml(YamlWith("image", "image: ../map.pgm")), HasSubstr("outside"));
  EXPECT_THAT(RefusedYaml(YamlWith("image", "image: other.pgm")),
              HasSubstr("does not hold the image 'other.pgm'"));
}

TEST(GridFormatTest, PathsThatLeaveTheArchiveAreRefused) {
  const TarFile yaml = {"map.yaml", kYaml}, pgm = {"map.pgm", Pgm()};
  EXPECT_THAT(Refused(MakeTar({yaml, pgm, {"../evil", "x"}})), HasSubstr("leads out"));
  EXPECT_THAT(Refused(MakeTar({yaml, pgm, {"/evil", "x"}})), HasSubstr("leads out"));
  EXPECT_THAT(Refused(MakeTar({yaml, pgm, {"link", "", AE_IFLNK}})), HasSubstr("is a link"));
}

TEST(GridFormatTest, WrongArchivesAreRefused) {
  const TarFile yaml = {"map.yaml", kYaml}, pgm = {"map.pgm", Pgm()};
  EXPECT_THAT(Refused(MakeTar({pgm})), HasSubstr("no YAML"));
  EXPECT_THAT(Refused(MakeTar({yaml, pgm, {"b.yml", kYaml}})), HasSubstr("two YAML"));
  EXPECT_THAT(Refused(MakeTar({yaml, pgm, pgm})), HasSubstr("'map.pgm' twice"));
  EXPECT_THAT(Refused(MakeTar({yaml})), HasSubstr("does not hold the image"));
  EXPECT_THAT(Refused("no tar at all"), HasSubstr("not a whole tar archive"));
  std::vector<TarFile> many = {yaml, pgm};
  for (int i = 0; i < 70; ++i) many.push_back({"f" + std::to_string(i), ""});
  EXPECT_THAT(Refused(MakeTar(many)), HasSubstr("more than 64 entries"));
}

TEST(GridFormatTest, CutOffArchiveIsRefused) {
  const std::string whole = MakeTar({{"map.yaml", kYaml}, {"map.pgm", Pgm()}});
  for (const std::size_t size : {100U, 512U, 700U, 1200U, 1540U}) {
    EXPECT_NE(Refused(whole.substr(0, size)), "") << size;
  }
}

TEST(GridFormatTest, WrongImagesNameTheirByte) {
  const auto refused = [](const std::string& pgm) {
    return Refused(MakeTar({{"map.yaml", kYaml}, {"map.pgm", pgm}}));
  };
  EXPECT_THAT(refused("\x89PNG\r\n\x1A\n"), HasSubstr("it looks like a PNG image"));
  EXPECT_THAT(refused("P5 3 2 255 abcde"),
              HasSubstr("grid.tar/map.pgm: byte 16: pixel 6 of 6: the file ends"));
  EXPECT_THAT(refused("P5 3 2 255 abcdefg"), HasSubstr("data follow the last pixel"));
  EXPECT_THAT(refused("P5 3 2 90 abcdef"), HasSubstr("brighter"));
  EXPECT_THAT(refused("P5 0 2 255 "), HasSubstr("no pixels"));
  EXPECT_THAT(refused("P5 999999 999999 255 "), HasSubstr("more than 4294967295 pixels"));
  EXPECT_THAT(refused("P5 99999999999999999999 1 255 "), HasSubstr("the width is more than"));
  EXPECT_THAT(refused("P5 1 1 65536 a"), HasSubstr("more than 65535"));
  EXPECT_THAT(refused("P2 2 1 9 1 x"), HasSubstr("no number for a pixel"));
  EXPECT_THAT(refused("P2 2 1 9 1"), HasSubstr("the file ends before a pixel"));
}

}  // namespace
}  // namespace lares::environment
