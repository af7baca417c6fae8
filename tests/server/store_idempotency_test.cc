#include "server/store/idempotency.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "server/store/sqlite.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

using State = KeyRecord::State;

class IdempotencyTest : public StoreTest {
 protected:
  static KeyRecord Answer(const std::string& body) {
    KeyRecord answer;
    answer.fingerprint = "f";
    answer.status = 201;
    answer.headers = "[]";
    answer.body = body;
    return answer;
  }
  IdempotencyKeys& keys() { return store_->idempotency_keys(); }
};

TEST_F(IdempotencyTest, AKeyIsNewThenInProgressThenAnsweredAndStaysSo) {
  EXPECT_EQ(keys().Take("k").state, State::kNew);
  EXPECT_EQ(keys().Take("k").state, State::kInProgress);
  EXPECT_EQ(keys().Take("other").state, State::kNew);
  keys().Finish("k", Answer("the first answer"));
  for (int i = 0; i < 2; ++i) {
    const KeyRecord record = keys().Take("k");
    EXPECT_EQ(record.state, State::kAnswered);
    EXPECT_EQ(record.fingerprint, "f");
    EXPECT_EQ(record.status, 201);
    EXPECT_EQ(record.body, "the first answer");
    Reopen();
  }
}

TEST_F(IdempotencyTest, AReleasedKeyIsNewAgainAndAnAnsweredOneIsNotReleased) {
  keys().Take("k");
  keys().Release("k");
  EXPECT_EQ(keys().Take("k").state, State::kNew);
  keys().Finish("k", Answer("a"));
  keys().Release("k");
  EXPECT_EQ(keys().Take("k").state, State::kAnswered);
}

TEST_F(IdempotencyTest, AKeyOfAProcessThatEndedBeforeItWroteIsNew) {
  if (store_->shared()) GTEST_SKIP() << "another server may be answering it: it stays for a day";
  keys().Take("k");
  Reopen();
  EXPECT_EQ(keys().Take("k").state, State::kNew);
}

TEST_F(IdempotencyTest, AVersionAndThatItsKeyIsDoneAreWrittenTogether) {
  keys().Take("k");
  NewVersion version = Version("lab", {Layer("a", PutBlob("a"))});
  version.request_key = "k";
  version.request_fingerprint = "print";
  store_->PutVersion(version);
  Reopen();  // the process ended before the answer was kept
  const KeyRecord record = keys().Take("k");
  EXPECT_EQ(record.state, State::kWritten);
  EXPECT_EQ(record.fingerprint, "print");
  EXPECT_EQ(record.written, "lab/1");
}

TEST_F(IdempotencyTest, ARefusedVersionDoesNotMarkItsKey) {
  if (store_->shared()) GTEST_SKIP() << "another server may be answering it: it stays for a day";
  keys().Take("k");
  NewVersion version = Version("lab", {Layer("a", PutBlob("a"))}, "*");
  version.request_key = "k";
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(version); }), Code::kPreconditionFailed);
  Reopen();
  EXPECT_EQ(keys().Take("k").state, State::kNew);
}

class KeyTableTest : public ::testing::Test {
 protected:
  KeyTableTest() { database_.RunScript(kIdempotencyTables); }
  void Answered(const std::string& key, int at_ms, const std::string& body) {
    TakeKey(database_, key, At(at_ms), limits_);
    KeyRecord answer;
    answer.status = 200;
    answer.body = body;
    FinishKey(database_, key, answer);
  }
  State StateOf(const std::string& key, int at_ms) {
    const Transaction undone(database_, Transaction::Kind::kWrite);
    return TakeKey(database_, key, At(at_ms), limits_).state;
  }
  static Time At(int ms) { return Time(std::chrono::milliseconds(ms)); }

  TemporaryFolder folder_{FastFolder()};
  SqliteDatabase database_{folder_.path() / "keys.sqlite", SqliteDatabase::Access::kWrite, ""};
  KeyLimits limits_{std::chrono::milliseconds(100), 3, 1000};
};

TEST_F(KeyTableTest, AnswersAreForgottenAfterTheirTime) {
  Answered("k", 1000, "a");
  EXPECT_EQ(StateOf("k", 1100), State::kAnswered);
  EXPECT_EQ(StateOf("k", 1101), State::kNew);
}

TEST_F(KeyTableTest, TheOldestAnswersGoWhenThereAreTooMany) {
  for (int i = 0; i < 5; ++i) Answered("k" + std::to_string(i), 1000 + i, "a");
  PruneKeys(database_, limits_);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(StateOf("k" + std::to_string(i), 1005), i < 2 ? State::kNew : State::kAnswered) << i;
  }
}

TEST_F(KeyTableTest, TheOldestAnswersGoWhenTheyAreTooLargeTogether) {
  Answered("old", 1000, std::string(500, 'a'));
  Answered("new", 1001, std::string(600, 'a'));
  PruneKeys(database_, limits_);
  EXPECT_EQ(StateOf("old", 1002), State::kNew);
  EXPECT_EQ(StateOf("new", 1002), State::kAnswered);
}

class BlobUsesTest : public StoreTest {};

TEST_F(BlobUsesTest, LayersAndDocumentsThatReferToABlobAreToldOnce) {
  const Blob blob = PutBlob("map");
  EXPECT_TRUE(store_->BlobUses(blob.sha256).empty());
  EXPECT_TRUE(store_->BlobUses("' OR 1 = 1").empty());
  store_->PutVersion(Version("lab", {Layer("a", blob)}));
  store_->PutVersion(Version("lab", {Layer("b", PutBlob("other"))}));  // carries `a` over
  store_->PutVersion(Version("room", {Layer("a", blob)}));
  store_->PutDocument(Recipe("r", "map"));
  const std::vector<BlobUse> uses = store_->BlobUses(blob.sha256);
  ASSERT_EQ(uses.size(), 3U);
  EXPECT_EQ(uses[0].environment + uses[1].environment, "labroom");
  EXPECT_EQ(uses[0].file_name, "a.dat");
  EXPECT_EQ(uses[2].document_kind, "recipe");
  EXPECT_EQ(uses[2].document, "r");
}

TEST_F(BlobUsesTest, FilesBesideAnObjectModelAreReferredTo) {
  const Blob image = PutBlob("image");
  NewDocument model = Recipe("bed", "model");
  model.kind = DocumentKind::kObjectModel;
  model.details_json = "{\"files\":[{\"sha256\":\"" + image.sha256 + "\"}]}";
  store_->PutDocument(model);
  ASSERT_EQ(store_->BlobUses(image.sha256).size(), 1U);
  EXPECT_EQ(store_->BlobUses(image.sha256)[0].document, "bed");
}

}  // namespace
}  // namespace lares::store::testing
