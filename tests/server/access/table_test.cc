#include "server/access/table.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::access {
namespace {

AccessTable Table(const std::string& operations) {
  return AccessTable("{\"operations\": {" + operations + "}}");
}

TEST(AccessTableTest, ReadsRoleKindAndEnvironments) {
  const AccessTable table = Table(
      R"("a": {"x-lares-role": "robot", "x-lares-kind": "query", "x-lares-environments": "named"})");
  const Rule rule = table.Of("a", "POST");
  EXPECT_EQ(rule.role, Role::kRobot);
  EXPECT_EQ(rule.kind, Rule::Kind::kQuery);
  EXPECT_EQ(rule.environments, Rule::Environments::kNamed);
}

TEST(AccessTableTest, WithoutAKindWhatIsNoGetWrites) {
  const AccessTable table = Table(R"("a": {"x-lares-role": "reader"})");
  EXPECT_EQ(table.Of("a", "GET").kind, Rule::Kind::kRead);
  EXPECT_EQ(table.Of("a", "HEAD").kind, Rule::Kind::kRead);
  EXPECT_EQ(table.Of("a", "DELETE").kind, Rule::Kind::kWrite);
}

TEST(AccessTableTest, AnOperationWithoutARoleIsForAdminsOnly) {
  const AccessTable table = Table(R"("a": {})");
  EXPECT_FALSE(table.Has("a"));
  EXPECT_EQ(table.Of("a", "GET").role, Role::kAdmin);
  EXPECT_EQ(table.Of("b", "GET").role, Role::kAdmin);
}

TEST(AccessTableTest, UnknownWordsAreRefused) {
  EXPECT_THROW(Table(R"("a": {"x-lares-role": "root"})"), Error);
  EXPECT_THROW(Table(R"("a": {"x-lares-role": "reader", "x-lares-kind": "x"})"), Error);
  EXPECT_THROW(Table(R"("a": {"x-lares-role": "reader", "x-lares-environments": "x"})"), Error);
  EXPECT_THROW(AccessTable("nothing"), Error);
}

}  // namespace
}  // namespace lares::access
