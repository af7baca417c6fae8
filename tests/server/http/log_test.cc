#include "server/http/log.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/time.h"

namespace lares::http {
namespace {

TEST(LogTest, ALineIsOneJsonObject) {
  const std::string line =
      FormatLogLine(LogLevel::kWarning, "say \"hi\"\n",
                    {{"path", "/a\nb"}, {"status", std::int64_t{200}}, {"duration_ms", 1.5}});
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["level"], "warning");
  EXPECT_EQ(json["message"], "say \"hi\"\n");
  EXPECT_EQ(json["path"], "/a\nb");
  EXPECT_EQ(json["status"], 200);
  EXPECT_EQ(json["duration_ms"], 1.5);
  EXPECT_TRUE(FromRfc3339(json["time"].get<std::string>()));
}

TEST(LogTest, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_NO_THROW(nlohmann::json::parse(FormatLogLine(LogLevel::kInfo, "\xff\xfe", {})));
}

TEST(LogTest, LevelsAreReadByName) {
  EXPECT_EQ(ParseLogLevel("warning"), LogLevel::kWarning);
  EXPECT_THROW(ParseLogLevel("loud"), Error);
}

}  // namespace
}  // namespace lares::http
