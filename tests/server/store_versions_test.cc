#include <gmock/gmock.h>

#include <thread>

#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class VersionsTest : public StoreTest {
 protected:
  EnvironmentVersion Put(const std::string& grid, int parent = 0) {
    NewVersion version = Version("flat", {Layer("grid", PutBlob(grid))});
    version.parent = parent;
    return store_->PutVersion(version);
  }
  std::string GridOf(int number) {
    return store_->ReadBlob(store_->GetVersion("flat", number).layers.at(0).blob.sha256);
  }
};

TEST_F(VersionsTest, VersionOffAnOlderOneIsABranchAndTheHeadStays) {
  Put("a");
  Put("b");
  const EnvironmentVersion branch = Put("c", 1);
  EXPECT_EQ(branch.number, 3);
  EXPECT_FALSE(branch.was_head);
  EXPECT_THAT(branch.parents, ElementsAre(1));
  EXPECT_EQ(store_->FindEnvironment("flat")->latest, 2);
  EXPECT_EQ(store_->FindEnvironment("flat")->count, 3);
  EXPECT_EQ(store_->GetVersion("flat", 0).number, 2);
  const EnvironmentVersion next = Put("d");
  EXPECT_EQ(next.number, 4);
  EXPECT_THAT(next.parents, ElementsAre(2));
  EXPECT_EQ(store_->Log("flat").size(), 4u);
}

TEST_F(VersionsTest, MergeHasTwoParentsAndBecomesTheHead) {
  Put("a");
  Put("b");
  Put("c", 1);
  NewVersion merge = Version("flat", {Layer("octomap", PutBlob("m"))});
  merge.merged = 3;
  const EnvironmentVersion merged = store_->PutVersion(merge);
  EXPECT_EQ(merged.origin, Origin::kMerge);
  EXPECT_THAT(merged.parents, ElementsAre(2, 3));
  EXPECT_EQ(store_->FindEnvironment("flat")->latest, 4);
  EXPECT_EQ(store_->GetVersion("flat", 4).parents, merged.parents);
}

TEST_F(VersionsTest, RollbackIsANewVersionWithTheOldLayers) {
  Put("a");
  Put("b");
  NewVersion back;
  back.environment = "flat";
  back.restored = 1;
  back.author = "ann";
  const EnvironmentVersion restored = store_->PutVersion(back);
  EXPECT_EQ(restored.number, 3);
  EXPECT_EQ(restored.origin, Origin::kRollback);
  EXPECT_EQ(restored.base, 1);
  EXPECT_THAT(restored.parents, ElementsAre(2));
  EXPECT_EQ(GridOf(3), "a");
  EXPECT_EQ(GridOf(2), "b");
}

TEST_F(VersionsTest, ParentThatThereIsNotIsRefusedAndNothingIsPut) {
  Put("a");
  EXPECT_EQ(CodeOf([&] { Put("b", 2); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { Put("b", -1); }), Code::kNotFound);
  NewVersion merge = Version("flat", {Layer("grid", PutBlob("m"))});
  merge.merged = 1;
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(merge); }), Code::kInvalid);
  EXPECT_EQ(store_->Log("flat").size(), 1u);
}

TEST_F(VersionsTest, WhoAndWhichMissionAreKept) {
  NewVersion version = Version("flat", {Layer("grid", PutBlob("a"))});
  version.author = "ann";
  version.robot = "amigo-1";
  version.mission = "tidy-up/17";
  store_->PutVersion(version);
  Reopen();
  EXPECT_EQ(store_->GetVersion("flat", 1).robot, "amigo-1");
  EXPECT_EQ(store_->GetVersion("flat", 1).mission, "tidy-up/17");
}

TEST_F(VersionsTest, AsOfATimeIsWhatWasTheHeadThen) {
  const Time first = Put("a").created;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const Time second = Put("b").created;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  Put("c", 1);
  EXPECT_EQ(store_->VersionAsOf("flat", first), 1);
  EXPECT_EQ(store_->VersionAsOf("flat", second - std::chrono::milliseconds(1)), 1);
  EXPECT_EQ(store_->VersionAsOf("flat", Now() + std::chrono::hours(1)), 2);
  EXPECT_EQ(CodeOf([&] { store_->VersionAsOf("flat", first - std::chrono::seconds(1)); }),
            Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->VersionAsOf("none", first); }), Code::kNotFound);
}

TEST_F(VersionsTest, TagNamesAVersionUntilItIsMovedOnPurpose) {
  Put("a");
  Put("b");
  EXPECT_EQ(store_->PutTag({"flat", "tidy", 0, {}, "ann", ""}, false).number, 2);
  EXPECT_EQ(store_->PutTag({"flat", "tidy", 2, {}, "", ""}, false).author, "ann");
  EXPECT_EQ(CodeOf([&] {
              store_->PutTag({"flat", "tidy", 1, {}, "", ""}, false);
            }),
            Code::kConflict);
  EXPECT_EQ(store_->PutTag({"flat", "tidy", 1, {}, "", ""}, true).number, 1);
  Reopen();
  EXPECT_EQ(store_->FindTag("flat", "tidy")->number, 1);
  EXPECT_EQ(store_->Tags("flat").size(), 1u);
  store_->DeleteTag("flat", "tidy");
  EXPECT_FALSE(store_->FindTag("flat", "tidy"));
  EXPECT_EQ(CodeOf([&] { store_->DeleteTag("flat", "tidy"); }), Code::kNotFound);
}

TEST_F(VersionsTest, NumbersAndLatestAreNoTags) {
  Put("a");
  for (const char* name : {"1", "007", "latest", "", "a b"}) {
    EXPECT_EQ(CodeOf([&] {
                store_->PutTag({"flat", name, 1, {}, "", ""}, false);
              }),
              Code::kInvalid);
  }
  EXPECT_EQ(CodeOf([&] { store_->PutTag({"flat", "x", 5, {}, "", ""}, false); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->PutTag({"none", "x", 0, {}, "", ""}, false); }), Code::kNotFound);
}

TEST_F(VersionsTest, PinKeepsARobotAtItsVersion) {
  Put("a");
  Put("b");
  store_->PutPin({"amigo", "flat", 1, {}, "ann"});
  Put("c");
  EXPECT_EQ(store_->FindPin("amigo", "flat")->number, 1);
  EXPECT_FALSE(store_->FindPin("pr2", "flat"));
  store_->PutPin({"amigo", "flat", 3, {}, ""});
  EXPECT_EQ(store_->Pins("amigo").at(0).number, 3);
  store_->PutPin({"pr2", "flat", 0, {}, ""});
  EXPECT_EQ(store_->Pins("").size(), 2u);
  store_->DeletePin("amigo", "flat");
  EXPECT_FALSE(store_->FindPin("amigo", "flat"));
  EXPECT_EQ(CodeOf([&] { store_->DeletePin("amigo", "flat"); }), Code::kNotFound);
}

TEST_F(VersionsTest, RevisionIsAnotherAfterEachWriteAndOnlyThen) {
  const std::int64_t before = store_->Revision();
  Put("a");
  const std::int64_t after = store_->Revision();
  EXPECT_NE(before, after);
  store_->ListEnvironments();
  EXPECT_EQ(store_->Revision(), after);
  EXPECT_THROW(Put("b", 9), Error);
  EXPECT_EQ(store_->Revision(), after);
}

// --- Finding ----------------------------------------------------------------------------------

class SearchTest : public StoreTest {
 protected:
  void Put(const std::string& id, std::vector<SearchKey> keys, const std::string& label = "",
           const std::string& layer = "semantic") {
    NewVersion version = Version(id, {Layer(layer, PutBlob(id))});
    version.keys = std::move(keys);
    version.label = label;
    store_->PutVersion(version);
  }
  std::vector<std::string> Find(std::vector<SearchCondition> all, std::size_t limit = 100,
                                const std::string& after = "") {
    EnvironmentSearch search;
    search.all_of = std::move(all);
    search.limit = limit;
    search.after = after;
    return IdsOf(store_->SearchEnvironments(search));
  }
};

TEST_F(SearchTest, EnvironmentsAreFoundByEachKeyWithoutCase) {
  Put("a", {{"room-number", "3.14"}, {"street", "High Street"}, {"holds", "x:Cup"}});
  Put("b", {{"room-number", "3.15"}, {"street", "High Street"}, {"holds", "x:Bed"}});
  EXPECT_THAT(Find({{"room-number", {"3.14"}}}), ElementsAre("a"));
  EXPECT_THAT(Find({{"street", {"high street"}}}), ElementsAre("a", "b"));
  EXPECT_THAT(Find({{"street", {"HIGH STREET"}}, {"holds", {"x:Bed"}}}), ElementsAre("b"));
  EXPECT_THAT(Find({{"holds", {"x:Bed", "x:Cup", "x:None"}}}), ElementsAre("a", "b"));
  EXPECT_THAT(Find({{"holds", {}}}), IsEmpty());
  EXPECT_THAT(Find({}), ElementsAre("a", "b"));
  EXPECT_THAT(store_->SearchValues("street"), ElementsAre("High Street"));
}

TEST_F(SearchTest, WordsOfLabelsAndValuesAreFoundWholeOrByTheirBeginning) {
  Put("flat-1", {{"holds", "http://x#CoffeeMachine"}}, "Müller's küche, 2nd floor");
  Put("flat-2", {{"street", "Kücheweg"}}, "office");
  EXPECT_THAT(Find({{"word", {"küche"}}}), ElementsAre("flat-1"));
  EXPECT_THAT(Find({{"word", {"küche"}, true}}), ElementsAre("flat-1", "flat-2"));
  EXPECT_THAT(Find({{"word", {"k"}, true}}), ElementsAre("flat-1", "flat-2"));
  EXPECT_THAT(Find({{"word", {"coffee"}, true}}), ElementsAre("flat-1"));
  EXPECT_THAT(Find({{"word", {"flat"}}}), ElementsAre("flat-1", "flat-2"));
  EXPECT_THAT(Find({{"word", {"2"}}}), ElementsAre("flat-2"));
}

TEST_F(SearchTest, OnlyTheHeadDecides) {
  Put("a", {{"holds", "x:Cup"}});
  Put("a", {{"holds", "x:Bed"}}, "", "semantic");
  EXPECT_THAT(Find({{"holds", {"x:Cup"}}}), IsEmpty());
  NewVersion branch = Version("a", {Layer("cloud", PutBlob("c"))});
  branch.parent = 1;
  branch.keys = std::vector<SearchKey>{{"holds", "x:Cup"}};
  store_->PutVersion(branch);
  EXPECT_THAT(Find({{"holds", {"x:Cup"}}}), IsEmpty());
  EXPECT_THAT(Find({{"layer", {"cloud"}}}), IsEmpty());
  store_->PutVersion(Version("a", {Layer("grid", PutBlob("g"))}));  // says nothing of what it holds
  EXPECT_THAT(Find({{"holds", {"x:Bed"}}, {"layer", {"grid"}}}), ElementsAre("a"));
}

TEST_F(SearchTest, PagesGoOnAfterTheLastId) {
  for (int i = 10; i < 35; ++i) {
    Put("e" + std::to_string(i), {{"level", std::to_string(i % 2)}});
  }
  const std::vector<std::string> first = Find({{"level", {"1"}}}, 5);
  EXPECT_THAT(first, ElementsAre("e11", "e13", "e15", "e17", "e19"));
  EXPECT_THAT(Find({{"level", {"0", "1"}}}, 3, "e19"), ElementsAre("e20", "e21", "e22"));
  EXPECT_THAT(Find({{"level", {"1"}}}, 5, "e33"), IsEmpty());
}

TEST_F(SearchTest, TimeOfTheHeadNarrows) {
  Put("a", {{"level", "1"}});
  const Time between = store_->FindEnvironment("a")->changed + std::chrono::milliseconds(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  Put("b", {{"level", "1"}});
  EnvironmentSearch search;
  search.changed_from = between;
  EXPECT_THAT(IdsOf(store_->SearchEnvironments(search)), ElementsAre("b"));
  search.all_of = {{"level", {"1"}}};
  EXPECT_THAT(IdsOf(store_->SearchEnvironments(search)), ElementsAre("b"));
  search.changed_until = between;
  search.changed_from.reset();
  EXPECT_THAT(IdsOf(store_->SearchEnvironments(search)), ElementsAre("a"));
}

TEST_F(SearchTest, FieldThatThereIsNotIsNamedWithThoseThatThereAre) {
  const Error error = ErrorOf([&] { Find({{"colour", {"red"}}}); });
  EXPECT_EQ(error.code(), Code::kInvalid);
  EXPECT_THAT(error.what(), HasSubstr("room-number"));
}

TEST_F(SearchTest, KeysCanBeGivenLaterForTheHeadOnly) {
  store_->PutVersion(Version("a", {Layer("semantic", PutBlob("s"))}));
  EXPECT_THAT(store_->EnvironmentsWithoutKeys(), ElementsAre("a"));
  store_->PutKeys("a", 7, {{"level", "2"}});
  EXPECT_THAT(Find({{"level", {"2"}}}), IsEmpty());
  store_->PutKeys("a", 1, {{"level", "2"}});
  EXPECT_THAT(Find({{"level", {"2"}}}), ElementsAre("a"));
  EXPECT_THAT(store_->EnvironmentsWithoutKeys(), IsEmpty());
}

}  // namespace
}  // namespace lares::store::testing
