// Skill templates as documents, recipes that nest stored ones, and what plans are asked for with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "server/knowledge/refusal.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using store::DocumentKind;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SkillsTest : public KnowledgeFixture {
 protected:
  static std::string Turtle(const std::string& body) {
    return "@prefix : <https://example.org/s#> .\n@prefix lares: <https://w3id.org/lares#> .\n"
           "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
           "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n" +
           body;
  }
  static std::string Template(const std::string& name, const std::string& action,
                              const std::string& more = "") {
    return ":" + name + "Template a lares:SkillTemplate ; lares:forAction " + action +
           " ; lares:skillName \"" + name + "\" ; " + more +
           "lares:skillOutcome [ lares:outcomeName \"succeeded\" ; lares:meansResult "
           "lares:COMPLETED_OK ] .\n";
  }
  static std::string Step(const std::string& task, const std::string& step,
                          const std::string& above) {
    return ":" + task +
           " rdfs:subClassOf lares:PurposefulAction , [ a owl:Restriction ; "
           "owl:onProperty lares:subAction ; owl:someValuesFrom :" +
           step + " ] .\n:" + step + " rdfs:subClassOf " + above + " .\n";
  }
  void PutRobot() {
    Put(DocumentKind::kRobot, "r",
        Turtle(":r a lares:Robot ; lares:subComponent :b , :c , :d . :b a lares:MobileBase . "
               ":c a lares:Camera . :d a lares:ObjectRecognitionComponent .\n"));
  }
  server::PlanAnswer Plan(const std::string& task,
                          const std::map<std::string, std::string>& set = {}) {
    server::PlanRequest request;
    request.task = task;
    request.robot = "r";
    request.set = set;
    return knowledge_->MakePlan(request);
  }
};

TEST_F(SkillsTest, AStoredTemplateChangesTheNextPlanUntilItIsRemoved) {
  PutRobot();
  Put(DocumentKind::kRecipe, "wave", Turtle(Step("Wave", "a", "lares:DownloadingData")));
  EXPECT_THAT(Plan("Wave").result.problems, ElementsAre(HasSubstr("no skill template is known")));
  const auto answer = Put(DocumentKind::kSkillTemplate, "follow",
                          Turtle(Template("Follow", "lares:DownloadingData")));
  ASSERT_EQ(answer.skill_templates.size(), 1u);
  const auto planned = Plan("Wave");
  ASSERT_TRUE(planned.result.plan) << ::testing::PrintToString(planned.result.problems);
  EXPECT_EQ(planned.result.plan->states[0].skill, "Follow");
  knowledge_->Remove(DocumentKind::kSkillTemplate, "follow");
  EXPECT_FALSE(Plan("Wave").result.plan);
}

// A recipe is read once for all plans: of its bytes, not of its name.
TEST_F(SkillsTest, ARecipeThatIsPutAgainChangesTheNextPlan) {
  PutRobot();
  Put(DocumentKind::kSkillTemplate, "follow", Turtle(Template("Follow", "lares:DownloadingData")));
  Put(DocumentKind::kRecipe, "wave", Turtle(Step("Wave", "a", "lares:DownloadingData")));
  ASSERT_TRUE(Plan("Wave").result.plan);
  EXPECT_EQ(Plan("Wave").result.plan->states[0].skill, "Follow");
  Put(DocumentKind::kRecipe, "wave", Turtle(Step("Wave", "b", "lares:Waiting")));
  ASSERT_TRUE(Plan("Wave").result.plan);
  EXPECT_EQ(Plan("Wave").result.plan->states[0].id, "b");
  EXPECT_NE(Plan("Wave").result.plan->states[0].skill, "Follow");
}

TEST_F(SkillsTest, AStoredTemplateIsThereAfterARestart) {
  Put(DocumentKind::kSkillTemplate, "follow", Turtle(Template("Follow", "lares:DownloadingData")));
  Open();
  const auto templates = knowledge_->SkillTemplates();
  EXPECT_TRUE(std::any_of(templates.begin(), templates.end(),
                          [](const auto& each) { return each.skill == "Follow"; }));
  for (const auto& module : knowledge_->Modules()) EXPECT_NE(module.id, "follow");
}

TEST_F(SkillsTest, AFaultyTemplateIsRefusedWithItsPlaceAndNothingChanges) {
  try {
    Put(DocumentKind::kSkillTemplate, "bad",
        Turtle("\n\n" + Template("Bad", "lares:Waiting", "lares:retryCount 1000 ; ")));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    EXPECT_THAT(error.what(), HasSubstr("retryCount"));
    ASSERT_TRUE(error.place());
    EXPECT_EQ(error.place()->line, 7);
  }
  EXPECT_FALSE(store_->FindDocument(DocumentKind::kSkillTemplate, "bad"));
  for (const auto& each : knowledge_->SkillTemplates()) EXPECT_NE(each.skill, "Bad");
}

TEST_F(SkillsTest, ADocumentWithoutTemplatesIsRefused) {
  EXPECT_THROW(Put(DocumentKind::kSkillTemplate, "none", Turtle(":a a lares:Cup .\n")), Error);
}

TEST_F(SkillsTest, ATemplateWithATreeThatIsNoneIsRefused) {
  EXPECT_THROW(
      Put(DocumentKind::kSkillTemplate, "tree",
          Turtle(Template("T", "lares:Waiting", "lares:treeFragment \"<Repeat><Skill/>\" ; "))),
      Error);
}

TEST_F(SkillsTest, ARecipeNestsAStoredOneByItsClass) {
  PutRobot();
  Put(DocumentKind::kRecipe, "inner",
      Turtle(":object a lares:RecipeParameter , owl:Class ; lares:parameterOf :Inner ; "
             "lares:parameterName \"object\" ; lares:parameterType \"class\" ; "
             "lares:parameterProperty lares:objectSought .\n" +
             Step("Inner", "wait", "lares:Waiting") +
             ":Inner rdfs:subClassOf [ a owl:Restriction ; owl:onProperty lares:subAction ; "
             "owl:someValuesFrom :infer ] .\n"
             ":infer rdfs:subClassOf lares:InferLikelyObjectLocations , [ a owl:Restriction ; "
             "owl:onProperty lares:objectActedOn ; owl:someValuesFrom :object ] .\n"));
  Put(DocumentKind::kRecipe, "outer",
      "@prefix in: <https://example.org/s#> .\n@prefix : <https://example.org/outer#> .\n"
      "@prefix lares: <https://w3id.org/lares#> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> "
      ".\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
      ":Outer rdfs:subClassOf lares:PurposefulAction , [ a owl:Restriction ; "
      "owl:onProperty lares:subAction ; owl:someValuesFrom :search ] .\n"
      ":search rdfs:subClassOf in:Inner , [ a owl:Restriction ; owl:onProperty lares:objectSought "
      "; "
      "owl:someValuesFrom lares:Cup ] .\n");
  const auto planned = Plan("Outer");
  ASSERT_TRUE(planned.result.plan) << ::testing::PrintToString(planned.result.problems);
  std::vector<std::string> values;
  for (const auto& state : planned.result.plan->states) {
    for (const auto& input : state.inputs) values.push_back(input.value);
  }
  EXPECT_THAT(values, Contains("https://w3id.org/lares#Cup"));
}

TEST_F(SkillsTest, TwoRecipesThatNestEachOtherAreRefused) {
  Put(DocumentKind::kRecipe, "a", Turtle(Step("A", "a1", "lares:Waiting")));
  Put(DocumentKind::kRecipe, "b", Turtle(Step("B", "b1", ":A")));
  try {
    Put(DocumentKind::kRecipe, "a", Turtle(Step("A", "a1", ":B")));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid) << error.what();
  }
}

TEST_F(SkillsTest, WhatARecipeDoesNotMeanIsAWarningWithItsPlace) {
  const auto answer =
      Put(DocumentKind::kRecipe, "odd",
          Turtle(Step("Odd", "a", "lares:Waiting") + "\n:a owl:subClassOf lares:Waiting .\n"));
  ASSERT_EQ(answer.remarks.size(), 1u);
  EXPECT_THAT(answer.remarks[0].message, HasSubstr("rdfs:subClassOf is meant"));
  EXPECT_EQ(answer.remarks[0].place.line, 8);
}

TEST_F(SkillsTest, ARecipesConstantsAreDefaultsThatCanBeSet) {
  PutRobot();
  Put(DocumentKind::kRecipe, "find",
      Turtle(Step("Find", "infer",
                  "lares:InferLikelyObjectLocations , [ a owl:Restriction ; owl:onProperty "
                  "lares:objectActedOn ; owl:someValuesFrom lares:Bottle ]")));
  const auto planned = Plan("Find", {{"object_class", "cup"}});
  ASSERT_TRUE(planned.result.plan) << ::testing::PrintToString(planned.result.problems);
  ASSERT_EQ(planned.result.plan->settings.size(), 1u);
  EXPECT_EQ(planned.result.plan->settings[0].value, "https://w3id.org/lares#Cup");
  EXPECT_EQ(planned.result.plan->settings[0].was, "bottle");
}

}  // namespace
}  // namespace lares::testing
