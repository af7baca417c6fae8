#include "server/cli/print.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lares::cli {
namespace {

TEST(PrintTest, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(FormatTable({"ID", "LABEL"}, {{"küche", "Kitchen"}, {"a", ""}}),
            "ID     LABEL\nküche  Kitchen\na\n");
}

TEST(PrintTest, NumbersAreForPeople) {
  EXPECT_EQ(FormatPercent(0.7283), "72.8 %");
  EXPECT_EQ(FormatBytes(0), "0 B");
  EXPECT_EQ(FormatBytes(999), "999 B");
  EXPECT_EQ(FormatBytes(1000), "1.0 kB");
  EXPECT_EQ(FormatBytes(209'715'200), "210 MB");
  EXPECT_EQ(Plural(1, "step"), "1 step");
  EXPECT_EQ(Plural(0, "step"), "0 steps");
  EXPECT_EQ(FormatTime("2026-01-31T12:34:56.000Z"), "2026-01-31 12:34");
  EXPECT_EQ(FormatTime("soon"), "soon");
}

TEST(PrintTest, RemarksCarryTheirPlace) {
  const Json remarks = Json::parse(
      R"([{"message":"mended","place":{"source":"a.owl","line":7,"column":2}},{"message":"bare"}])");
  EXPECT_EQ(FormatRemarks(remarks, "repaired:"), "repaired:\n  a.owl:7:2: mended\n  bare\n");
  EXPECT_EQ(FormatRemarks(Json::array(), "repaired:"), "");
}

}  // namespace
}  // namespace lares::cli
