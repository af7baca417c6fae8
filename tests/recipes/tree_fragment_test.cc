#include <gmock/gmock.h>

#include "recipes/plan/export_fragment.h"

namespace lares::testing {
namespace {

using recipes::ParseTreeFragment;
using recipes::TreeDecorator;
using recipes::TreeFragmentProblems;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(TreeFragment, IsReadFromTheOutsideIn) {
  const auto fragment = ParseTreeFragment(
      " <RetryUntilSuccessful num_attempts=\"3\" name='again'>\n"
      "<Timeout msec='60000' ><Skill /></Timeout></RetryUntilSuccessful> ");
  EXPECT_THAT(fragment.problems, IsEmpty());
  EXPECT_THAT(fragment.decorators,
              ElementsAre(TreeDecorator{"RetryUntilSuccessful", "num_attempts", 3},
                          TreeDecorator{"Timeout", "msec", 60000}));
  EXPECT_THAT(TreeFragmentProblems("<Skill/>"), IsEmpty());
  EXPECT_THAT(TreeFragmentProblems("<Skill></Skill>"), IsEmpty());
}

TEST(TreeFragment, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "no <Skill/>"},
      {"<Delay delay_msec=\"5\"></Delay>", "<Delay> holds nothing"},
      {"<Delay delay_msec=\"5\"/>", "<Delay> holds nothing"},
      {"<Skill/><Skill/>", "more than one root"},
      {"<Delay delay_msec=\"5\"><Skill/><Skill/></Delay>", "more than once"},
      {"<Inverter><Skill/></Inverter>", "<Inverter> cannot be used"},
      {"<RunOnce><Skill/></RunOnce>", "<RunOnce> cannot be used"},
      {"<Timeout><Skill/></Timeout>", "lacks 'msec'"},
      {"<Timeout msec=\"0\"><Skill/></Timeout>", "from 1 to"},
      {"<Timeout msec=\"-1\"><Skill/></Timeout>", "from 1 to"},
      {"<Timeout msec=\"1e3\"><Skill/></Timeout>", "whole number"},
      {"<Timeout msec=\"{limit}\"><Skill/></Timeout>", "whole number"},
      {"<Timeout msec=\"99999999999999999999\"><Skill/></Timeout>", "whole number"},
      {"<RetryUntilSuccessful num_attempts=\"-1\"><Skill/></RetryUntilSuccessful>",
       "from 1 to 101"},
      {"<Timeout msec=\"5\" _skipIf=\"true\"><Skill/></Timeout>", "no attribute '_skipIf'"},
      {"<Timeout msec=\"5\" msec=\"6\"><Skill/></Timeout>", "twice"},
      {"<Timeout msec=\"5\"><Delay delay_msec=\"5\"><Skill/></Delay></Timeout>", "leaves no time"},
      {"<Timeout msec=\"5\"><Skill/>", "is not closed"},
      {"<Timeout msec=\"5\"><Skill/></Delay>", "closes nothing"},
      {"<Timeout msec=5><Skill/></Timeout>", "not in quotes"},
      {"<Skill port=\"x\"/>", "takes no attributes"},
      {"<Skill>go</Skill>", "text stands"},
      {"<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]><Skill/>", "declarations"},
      {"<!-- --><Skill/>", "comments"},
      {"<Timeout msec=\"&#53;\"><Skill/></Timeout>", "< or &"},
      {"<Skill/>\xff", "UTF-8"}};
  for (const auto& [xml, sentence] : cases) {
    const auto problems = TreeFragmentProblems(xml);
    ASSERT_THAT(problems, Not(IsEmpty())) << xml;
    EXPECT_THAT(problems.front(), HasSubstr(sentence)) << xml;
  }
}

TEST(TreeFragment, IsBoundedInSizeAndDepth) {
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<Delay delay_msec=\"1\">";
  EXPECT_THAT(TreeFragmentProblems(deep), ElementsAre(HasSubstr("deep")));
  EXPECT_THAT(TreeFragmentProblems(std::string(5'000'000, '<')), ElementsAre(HasSubstr("longer")));
}

}  // namespace
}  // namespace lares::testing
