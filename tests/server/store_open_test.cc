#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "base/file.h"
#include "base/hash.h"
#include "tests/server/old_schemas.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

void RunSql(const fs::path& file, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sql;
  sqlite3_close(database);
}

class OpenTest : public ::testing::Test {
 protected:
  std::unique_ptr<Store> Open() { return OpenSqliteStore({folder_.path()}); }
  Error OpenError() {
    return ErrorOf([&] { Open(); });
  }
  TemporaryFolder folder_;
};

TEST_F(OpenTest, FoldersAreCreatedAsDeepAsNeeded) {
  const auto store = OpenSqliteStore({folder_.path() / "a" / "b" / "c"});
  EXPECT_TRUE(store->ListEnvironments().empty());
  EXPECT_EQ(store->health(), "");
  EXPECT_TRUE(fs::is_directory(folder_.path() / "a" / "b" / "c" / "blobs"));
}

TEST_F(OpenTest, CleanCloseLeavesOnlyTheDatabaseAndTheLock) {
  Open()->PutDocument(Recipe("a", "1"));
  EXPECT_FALSE(fs::exists(folder_.path() / "lares.sqlite-wal"));
  EXPECT_TRUE(fs::exists(folder_.path() / "lares.sqlite"));
  EXPECT_TRUE(Open()->FindDocument(DocumentKind::kRecipe, "a"));
}

TEST_F(OpenTest, SecondOpeningInTheSameProcessIsAConflictNamingIt) {
  const auto store = Open();
  const Error error = OpenError();
  EXPECT_EQ(error.code(), Code::kConflict);
  EXPECT_THAT(error.hint(), HasSubstr(std::to_string(::getpid())));
}

TEST_F(OpenTest, AnotherProcessIsToldWhoHoldsTheStore) {
  int ready[2];
  int done[2];
  ASSERT_EQ(::pipe(ready), 0);
  ASSERT_EQ(::pipe(done), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(done[1]);
    try {
      const auto store = Open();
      char byte = 'r';
      const bool ok = ::write(ready[1], &byte, 1) == 1 && ::read(done[0], &byte, 1) == 1;
      ::_exit(ok ? 0 : 1);
    } catch (...) {
      ::_exit(2);
    }
  }
  ::close(ready[1]);
  ::close(done[0]);
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const Error error = OpenError();
  EXPECT_EQ(error.code(), Code::kConflict);
  EXPECT_THAT(error.hint(), HasSubstr(std::to_string(child)));
  ASSERT_EQ(::write(done[1], &byte, 1), 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_NO_THROW(Open());
  ::close(ready[0]);
  ::close(done[1]);
}

TEST_F(OpenTest, NewerSchemaIsRefusedByItsNumberAndLeftAlone) {
  Open()->PutDocument(Recipe("a", "1"));
  RunSql(folder_.path() / "lares.sqlite", "UPDATE schema_version SET version = 7");
  const Error error = OpenError();
  EXPECT_EQ(error.code(), Code::kInvalid);
  EXPECT_THAT(error.what(), HasSubstr("schema 7"));
  EXPECT_THROW(MigrateSqliteStore({folder_.path()}), Error);
  RunSql(folder_.path() / "lares.sqlite", "UPDATE schema_version SET version = 3");
  EXPECT_TRUE(Open()->FindDocument(DocumentKind::kRecipe, "a"));
}

class OldStoreTest : public OpenTest, public ::testing::WithParamInterface<int> {
 protected:
  OldStoreTest() {
    Open();  // for its folders
    fs::remove(file_);
    RunSql(file_, kSchema2);
    if (GetParam() == 1) RunSql(file_, kBackToSchema1);
    for (const std::string text : {"one", "two"}) {
      const std::string sha256 = Sha256Hex(text);
      fs::create_directories(folder_.path() / "blobs" / sha256.substr(0, 2));
      WriteFileAtomically(folder_.path() / "blobs" / sha256.substr(0, 2) / sha256.substr(2), text);
    }
  }
  const fs::path file_ = folder_.path() / "lares.sqlite";
};

TEST_P(OldStoreTest, IsRefusedByTheNameOfTheCommandAndLeftAlone) {
  const std::string before = ReadFile(file_);
  const Error error = OpenError();
  EXPECT_EQ(error.code(), Code::kInvalid);
  EXPECT_THAT(error.what(), HasSubstr("schema " + std::to_string(GetParam())));
  EXPECT_THAT(error.hint(), HasSubstr("lares store migrate --data " + folder_.path().string()));
  EXPECT_EQ(ReadFile(file_), before);
}

TEST_P(OldStoreTest, IsMigratedWithEverythingAndKeptAsItWas) {
  const std::string before = ReadFile(file_);
  const MigrationReport report = MigrateSqliteStore({folder_.path()});
  EXPECT_EQ(report.from, GetParam());
  EXPECT_EQ(report.to, 3);
  EXPECT_TRUE(fs::is_regular_file(report.kept_file));

  const std::unique_ptr<Store> store = Open();
  EXPECT_TRUE(store->Verify().empty());
  EXPECT_EQ(store->FindDocument(DocumentKind::kRecipe, "fetch")->version, 2);
  EXPECT_FALSE(store->FindDocument(DocumentKind::kRecipe, "gone"));
  EXPECT_EQ(store->FindByName(DocumentKind::kRecipe, "Fetch").size(), 1u);
  const std::vector<EnvironmentVersion> log = store->Log("kitchen");
  ASSERT_EQ(log.size(), 2u);
  EXPECT_EQ(log[0].parents, std::vector<int>{1});
  EXPECT_EQ(log[0].author, "bob");
  EXPECT_EQ(log[0].label, "Our kitchen");
  EXPECT_TRUE(log[1].parents.empty());
  EXPECT_EQ(store->FindEnvironment("kitchen")->count, 2);
  EXPECT_EQ(store->FindEnvironment("kitchen")->changed, log[0].created);
  EXPECT_EQ(store->EnvironmentsWithoutKeys(), std::vector<std::string>{"kitchen"});
  EXPECT_EQ(store->PutVersion(Version("kitchen", {Layer("grid", log[1].layers[0].blob)})).number,
            3);
}

TEST_P(OldStoreTest, MigratingTwiceDoesNothingTheSecondTime) {
  MigrateSqliteStore({folder_.path()});
  const MigrationReport again = MigrateSqliteStore({folder_.path()});
  EXPECT_EQ(again.from, again.to);
  EXPECT_TRUE(again.kept_file.empty());
}

INSTANTIATE_TEST_SUITE_P(Schemas, OldStoreTest, ::testing::Values(1, 2));

TEST_F(OpenTest, DatabaseOfAnotherProgramIsRefusedAndLeftAlone) {
  RunSql(folder_.path() / "lares.sqlite", "CREATE TABLE theirs (x)");
  const std::string before = ReadFile(folder_.path() / "lares.sqlite");
  EXPECT_EQ(OpenError().code(), Code::kInvalid);
  EXPECT_EQ(ReadFile(folder_.path() / "lares.sqlite"), before);
}

TEST_F(OpenTest, FileThatIsNoDatabaseIsRefusedAndLeftAlone) {
  const std::string text(5000, 'x');
  WriteFileAtomically(folder_.path() / "lares.sqlite", text);
  const Error error = OpenError();
  EXPECT_EQ(error.code(), Code::kIo);
  EXPECT_THAT(error.what(), HasSubstr("not a database"));
  EXPECT_THAT(error.what(), HasSubstr((folder_.path() / "lares.sqlite").string()));
  EXPECT_EQ(ReadFile(folder_.path() / "lares.sqlite"), text);
}

TEST_F(OpenTest, FolderThatIsAFileIsAFault) {
  std::ofstream(folder_.path() / "file") << "x";
  EXPECT_EQ(CodeOf([&] { OpenSqliteStore({folder_.path() / "file"}); }), Code::kIo);
  EXPECT_EQ(CodeOf([&] { OpenSqliteStore({folder_.path() / "file" / "below"}); }), Code::kIo);
}

}  // namespace
}  // namespace lares::store::testing
