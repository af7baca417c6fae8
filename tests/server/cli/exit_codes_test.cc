#include "server/cli/exit_codes.h"

#include <gmock/gmock.h>

#include <map>

#include "base/error.h"
#include "base/file.h"
#include "server/http/client.h"
#include "server/http/problem.h"

namespace lares::cli {
namespace {

TEST(ExitCodesTest, EveryProblemOfTheServerHasExactlyOne) {
  std::map<std::string_view, int> count;
  for (const ExitMeaning& meaning : ExitMeanings()) {
    for (const std::string_view code : meaning.problems) ++count[code];
  }
  for (const http::ProblemKind& kind : http::ProblemKinds()) {
    EXPECT_EQ(count[kind.code], 1) << kind.code;
  }
  EXPECT_EQ(count.size(), http::ProblemKinds().size());
}

TEST(ExitCodesTest, FaultsAreToldApart) {
  EXPECT_EQ(ExitCodeOf(Error(Code::kInvalid, "x")), ExitCode::kRefused);
  EXPECT_EQ(ExitCodeOf(http::NoServerError(Code::kUnavailable, "x")), ExitCode::kNoServer);
  EXPECT_EQ(ExitCodeOf(Error(Code::kUnavailable, "x")), ExitCode::kUnavailable);
  EXPECT_EQ(ExitCodeOf(std::runtime_error("x")), ExitCode::kInternal);
  EXPECT_EQ(ExitCodeOf("not-feasible"), ExitCode::kNoPlan);
  EXPECT_EQ(ExitCodeOf("of-a-later-version"), ExitCode::kInternal);
}

TEST(ExitCodesTest, TheGuideListsTheSameCodes) {
  const std::string guide = ReadFile(std::string(LARES_SOURCE_DIR) + "/docs/guide.md");
  for (const ExitMeaning& meaning : ExitMeanings()) {
    EXPECT_THAT(guide, ::testing::HasSubstr("| " + std::to_string(static_cast<int>(meaning.code)) +
                                            " | " + std::string(meaning.meaning) + " |\n"));
  }
}

TEST(ExitCodesTest, TheTextNamesEveryCode) {
  for (const ExitMeaning& meaning : ExitMeanings()) {
    EXPECT_THAT(ExitCodesText(), ::testing::HasSubstr(std::string(meaning.meaning)));
  }
}

}  // namespace
}  // namespace lares::cli
