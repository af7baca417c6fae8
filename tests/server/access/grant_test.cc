#include "server/access/grant.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::access {
namespace {

Grant Scoped(std::vector<std::string> environments) {
  Grant grant;
  grant.environments = std::move(environments);
  return grant;
}

TEST(GrantTest, WithoutPatternsEveryEnvironmentIsReached) { EXPECT_TRUE(Reaches(Grant{}, "lab")); }

TEST(GrantTest, AnIdReachesThatOneAndAPrefixAllThatBeginSo) {
  const Grant grant = Scoped({"lab", "flat-*"});
  for (const char* own : {"lab", "flat-", "flat-1", "flat-*"}) EXPECT_TRUE(Reaches(grant, own));
  for (const char* foreign : {"", "la", "lab2", "Lab", "flat", "a-flat-1", "xflat-1"}) {
    EXPECT_FALSE(Reaches(grant, foreign)) << foreign;
  }
}

TEST(GrantTest, PatternsAreIdsOrTheirBeginnings) {
  for (const char* good : {"lab", "flat-*", "a*"}) EXPECT_NO_THROW(CheckPattern(good));
  for (const char* bad : {"", "*", "a*b", "**", "a b", "a b*", "../x", "a/*"}) {
    EXPECT_THROW(CheckPattern(bad), Error) << bad;
  }
}

TEST(GrantTest, RolesAreInOrderAndKeepTheirNames) {
  EXPECT_LT(Role::kPublic, Role::kReader);
  EXPECT_LT(Role::kReader, Role::kRobot);
  EXPECT_LT(Role::kRobot, Role::kEditor);
  EXPECT_LT(Role::kEditor, Role::kAdmin);
  for (const Role role :
       {Role::kPublic, Role::kReader, Role::kRobot, Role::kEditor, Role::kAdmin}) {
    EXPECT_EQ(ParseRole(ToString(role)), role);
  }
  EXPECT_FALSE(ParseRole("root"));
  EXPECT_FALSE(ParseRole(""));
}

}  // namespace
}  // namespace lares::access
