// What recipes' authors probably did not mean.
#include <gmock/gmock.h>

#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> Suspicions(const std::string& recipe) {
  World world = Catalogue();
  world.Put("recipe", recipe);
  return recipes::FindSuspicions(Engines(), world.view(), "recipe");
}

const std::string kGo = "lares:Translation-LocationChange";

std::string Sound() {
  return StateMachine({{"a", kGo}, {"b", kGo}}, "a", {"b"}, {{"a", "COMPLETED_OK", "b"}});
}

TEST(Suspicions, ASoundRecipeHasNone) {
  EXPECT_THAT(Suspicions(Sound()), IsEmpty());
  EXPECT_THAT(Suspicions(PartialOrder({{"a", kGo}, {"b", kGo}}, {{"a", "b"}})), IsEmpty());
}

TEST(Suspicions, OurLibraryHasNone) {
  for (const char* name :
       {"semantic-mapping", "object-search", "fetch-and-serve", "fetch-drink", "patrol"}) {
    World world = Catalogue();
    world.PutFile("recipe", Source(std::string("recipes/library/") + name + ".ttl"));
    EXPECT_THAT(recipes::FindSuspicions(Engines(), world.view(), "recipe"), IsEmpty()) << name;
  }
}

TEST(Suspicions, AMisspeltAxiomIsNamedWithWhatIsMeant) {
  EXPECT_THAT(Suspicions(Sound() + ":c owl:subClassOf " + kGo + " .\n"),
              ElementsAre(AllOf(HasSubstr("owl#subClassOf> is no term of OWL"),
                                HasSubstr("rdfs:subClassOf is meant"))));
  EXPECT_THAT(Suspicions(Sound() + ":c rdfs:subclassof " + kGo + " .\n"),
              ElementsAre(HasSubstr("rdfs:subClassOf is meant")));
  EXPECT_THAT(Suspicions(Sound() + ":c a owl:Classs .\n"),
              ElementsAre(AllOf(HasSubstr("owl#Classs>"), HasSubstr("says nothing"))));
}

TEST(Suspicions, ATransitionWrittenTheWrongWayRoundIsNamed) {
  EXPECT_THAT(Suspicions(Sound() + ":Task rdfs:subClassOf " + Has("lares:stateTransition", ":t") +
                         " . :a lares:fromState :t . :t lares:toState :b .\n"),
              ElementsAre(AllOf(HasSubstr("'a' <https://example.org/test#a> says from state"),
                                HasSubstr("the other way round?"))));
}

TEST(Suspicions, CauseAndStateInEachOthersPlaceAreNamed) {
  EXPECT_THAT(Suspicions(Sound() + ":Task rdfs:subClassOf " + Has("lares:stateTransition", ":t") +
                         " . :t lares:fromState lares:COMPLETED_OK ; lares:causedBy :a ; "
                         "lares:toState :b .\n"),
              Contains(HasSubstr("causedBy and fromState are swapped?")));
}

TEST(Suspicions, ADeviceThatIsActedOnIsNamed) {
  EXPECT_THAT(
      Suspicions(PartialOrder({{"a", "lares:GraspingSomething , " +
                                         Some("lares:objectActedOn", "lares:GripperComponent") +
                                         " , " + Some("lares:deviceUsed", "lares:Cup")}},
                              {})),
      ElementsAre(HasSubstr("objectActedOn and deviceUsed are swapped?")));
}

TEST(Suspicions, AnIndividualWhereAClassBelongsIsNamed) {
  EXPECT_THAT(Suspicions(Turtle(":Task rdfs:subClassOf lares:PurposefulAction , " +
                                Some("lares:subAction", ":a") + " . :a a " + kGo + " .\n")),
              ElementsAre(AllOf(HasSubstr("'a' <https://example.org/test#a> is an individual"),
                                HasSubstr("should be a subclass"))));
  EXPECT_THAT(
      Suspicions(PartialOrder({{"a", kGo + " , " + Some("lares:toLocation", ":here")}}, {}) +
                 ":here a lares:Point2D .\n"),
      ElementsAre(HasSubstr("hasValue is for individuals")));
  EXPECT_THAT(Suspicions(Sound() + ":cup1 a lares:Cup ; rdfs:subClassOf lares:PhysicalObject .\n"),
              ElementsAre(HasSubstr("is put below the class")));
}

}  // namespace
}  // namespace lares::testing
