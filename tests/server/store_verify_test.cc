#include <gmock/gmock.h>
#include <sqlite3.h>

#include <fstream>

#include "base/hash.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class VerifyTest : public ::testing::Test {
 protected:
  VerifyTest() : store_(OpenSqliteStore({folder_.path()})) {
    NewDocument document = Recipe("doc", "document bytes");
    document.names = {{"name", "label", "t"}};
    store_->PutDocument(document);
    store_->PutDocument(Recipe("doc", "second"));
    const auto writer = store_->NewBlob();
    writer->Append("layer bytes");
    store_->PutVersion(Version("env", {Layer("a", writer->Commit())}));
  }
  // Done behind the store's back.
  void Tamper(const char* sql) {
    store_.reset();
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder_.path() / "lares.sqlite").c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sql;
    sqlite3_close(database);
    store_ = OpenSqliteStore({folder_.path()});
  }

  TemporaryFolder folder_;
  std::unique_ptr<Store> store_;
};

TEST_F(VerifyTest, SoundStoreHasNoProblems) { EXPECT_THAT(store_->Verify(), IsEmpty()); }

TEST_F(VerifyTest, AbsentBlobIsNamed) {
  fs::remove(store_->BlobPath(Sha256Hex("layer bytes")));
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr(Sha256Hex("layer bytes"))));
}

TEST_F(VerifyTest, ShortenedBlobIsNamed) {
  fs::resize_file(store_->BlobPath(Sha256Hex("document bytes")), 5);
  EXPECT_THAT(store_->Verify(),
              ElementsAre(HasSubstr("has 5 bytes, not 14"), HasSubstr("is damaged")));
}

TEST_F(VerifyTest, StrangeFileAmongTheBlobsIsNamed) {
  std::ofstream(folder_.path() / "blobs" / "note.txt") << "x";
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr("note.txt")));
}

TEST_F(VerifyTest, GapInTheVersionsIsNamed) {
  Tamper("UPDATE document_versions SET number = 3 WHERE number = 2");
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr("recipe doc")));
  Tamper("UPDATE environments SET latest = 2");
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr("recipe doc"), HasSubstr("environment env")));
}

TEST_F(VerifyTest, VersionWithoutLayersIsNamed) {
  Tamper("DELETE FROM layers");
  EXPECT_THAT(store_->Verify(), ElementsAre("environment env version 1 has no layer"));
}

TEST_F(VerifyTest, NameOfAnOldVersionThatIsStillCurrentIsNamed) {
  Tamper("UPDATE document_names SET current = 1");
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr("'name'")));
}

TEST_F(VerifyTest, RowThatRefersToNothingIsNamed) {
  Tamper("INSERT INTO layers VALUES (99, 'x', '', '', (SELECT sha256 FROM layers), 11, '{}')");
  EXPECT_THAT(store_->Verify(), ElementsAre(HasSubstr("layers refers to no row")));
}

}  // namespace
}  // namespace lares::store::testing
