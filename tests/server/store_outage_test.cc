// A PostgreSQL that is killed and comes back.
#include <gtest/gtest.h>

#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

TEST(PostgresOutageTest, WritesAreRefusedWhileItIsAwayAndWhatWasAcknowledgedIsThereAfterwards) {
  OwnPostgres postgres;
  const TemporaryFolder blobs{FastFolder()};
  const std::unique_ptr<Store> store = OpenPostgresStore({postgres.NewDatabase(), blobs.path()});
  store->PutDocument(Recipe("kept", "one"));
  EXPECT_EQ(store->health(), "");

  postgres.Kill();
  EXPECT_EQ(CodeOf([&] { store->PutDocument(Recipe("refused", "two")); }), Code::kUnavailable);
  EXPECT_EQ(CodeOf([&] { store->ListDocuments(DocumentKind::kRecipe); }), Code::kUnavailable);
  EXPECT_NE(store->health(), "");

  postgres.Start();
  EXPECT_EQ(store->health(), "");
  EXPECT_TRUE(store->FindDocument(DocumentKind::kRecipe, "kept"));
  EXPECT_FALSE(store->FindDocument(DocumentKind::kRecipe, "refused"));
  EXPECT_EQ(store->PutDocument(Recipe("kept", "three")).version, 2);
  EXPECT_EQ(store->Verify(), std::vector<std::string>{});
}

TEST(PostgresOutageTest, ServerThatCannotBeReachedIsNamedAsThat) {
  const TemporaryFolder blobs{FastFolder()};
  EXPECT_EQ(CodeOf([&] {
              OpenPostgresStore({"host=/nowhere dbname=x", blobs.path()});
            }),
            Code::kUnavailable);
}

}  // namespace
}  // namespace lares::store::testing
