#include <gmock/gmock.h>

#include "tests/server/store_fixture.h"

namespace lares::store {
namespace {

using namespace testing;
using std::chrono::milliseconds;
using ::testing::ElementsAre;

class StoreAccessTest : public StoreTest {
 protected:
  static TokenRecord Token(const std::string& id, std::int64_t created_ms = 1000) {
    TokenRecord token;
    token.id = id;
    token.label = "küche";
    token.role = "robot";
    token.environments = {"flat-*", "lab"};
    token.secret_sha256 = std::string(64, 'a');
    token.created = Time(milliseconds(created_ms));
    token.expires = Time(milliseconds(9000));
    token.max_requests_per_minute = 1;
    token.max_bytes_per_day = std::int64_t{1} << 40;
    token.max_queries = 3;
    return token;
  }
  static AuditRecord Audit(std::int64_t time_ms, const std::string& token,
                           const std::string& environment, int status = 201) {
    AuditRecord record;
    record.time = Time(milliseconds(time_ms));
    record.token = token;
    record.label = "label of " + token;
    record.operation = "putEnvironmentVersion";
    record.target = "/v1/environments/" + environment + "/versions/3";
    record.environment = environment;
    record.version = 3;
    record.status = status;
    record.result = status < 300 ? "done" : "invalid";
    record.request_id = "r1";
    record.bytes = 100;
    return record;
  }
  std::vector<std::int64_t> TimesOf(const AuditQuery& query) const {
    std::vector<std::int64_t> times;
    for (const AuditRecord& record : store_->ListAudit(query)) {
      times.push_back(record.time.time_since_epoch().count());
    }
    return times;
  }
};

TEST_F(StoreAccessTest, ATokenComesBackAsItWasPutAlsoAfterReopening) {
  EXPECT_FALSE(store_->HasTokens());
  store_->AddToken(Token("abc"));
  Reopen();
  EXPECT_TRUE(store_->HasTokens());
  const TokenRecord token = store_->FindToken("abc").value();
  const TokenRecord put = Token("abc");
  EXPECT_EQ(token.label, put.label);
  EXPECT_EQ(token.role, put.role);
  EXPECT_EQ(token.environments, put.environments);
  EXPECT_EQ(token.secret_sha256, put.secret_sha256);
  EXPECT_EQ(token.created, put.created);
  EXPECT_EQ(token.expires, put.expires);
  EXPECT_EQ(token.revoked, std::nullopt);
  EXPECT_EQ(token.max_requests_per_minute, put.max_requests_per_minute);
  EXPECT_EQ(token.max_bytes_per_day, put.max_bytes_per_day);
  EXPECT_EQ(token.max_queries, put.max_queries);
  EXPECT_FALSE(store_->FindToken("ABC"));
}

TEST_F(StoreAccessTest, TokensAreListedByCreationAndIdsAreTakenOnce) {
  store_->AddToken(Token("b", 1));
  store_->AddToken(Token("a", 2));
  EXPECT_THAT(IdsOf(store_->ListTokens()), ElementsAre("b", "a"));
  EXPECT_EQ(CodeOf([&] { store_->AddToken(Token("a")); }), Code::kConflict);
  EXPECT_EQ(CodeOf([&] { store_->AddToken(Token("a b")); }), Code::kInvalid);
  TokenRecord odd = Token("c");
  odd.label = "\xff";
  EXPECT_EQ(CodeOf([&] { store_->AddToken(odd); }), Code::kInvalid);
  EXPECT_EQ(store_->ListTokens().size(), 2u);
}

TEST_F(StoreAccessTest, ARevokedTokenKeepsTheTimeOfItsFirstRevocation) {
  store_->AddToken(Token("a"));
  EXPECT_EQ(store_->RevokeToken("a", Time(milliseconds(5))).revoked, Time(milliseconds(5)));
  EXPECT_EQ(store_->RevokeToken("a", Time(milliseconds(7))).revoked, Time(milliseconds(5)));
  EXPECT_EQ(store_->FindToken("a")->revoked, Time(milliseconds(5)));
  EXPECT_EQ(CodeOf([&] { store_->RevokeToken("b", Time(milliseconds(7))); }), Code::kNotFound);
}

TEST_F(StoreAccessTest, TheAuditLogComesNewestFirstInPagesAndFiltered) {
  for (int i = 1; i <= 5; ++i) store_->AddAudit(Audit(i, i % 2 == 0 ? "a" : "b", "flat"));
  store_->AddAudit(Audit(6, "a", "lab", 422));
  EXPECT_THAT(TimesOf({}), ElementsAre(6, 5, 4, 3, 2, 1));
  EXPECT_THAT(TimesOf({.since = Time(milliseconds(4))}), ElementsAre(6, 5, 4));
  EXPECT_THAT(TimesOf({.token = "a"}), ElementsAre(6, 4, 2));
  EXPECT_THAT(TimesOf({.environment = "lab"}), ElementsAre(6));
  const std::vector<AuditRecord> page = store_->ListAudit({.limit = 2});
  ASSERT_EQ(page.size(), 2u);
  EXPECT_THAT(TimesOf({.before = page.back().id, .limit = 2}), ElementsAre(4, 3));
  EXPECT_EQ(page[0].label, "label of a");
  EXPECT_EQ(page[0].status, 422);
  EXPECT_EQ(page[0].version, 3);
  EXPECT_EQ(page[0].target, "/v1/environments/lab/versions/3");
}

TEST_F(StoreAccessTest, OnlyDoneWritesOfTheTokenSinceThenCountAsStored) {
  store_->AddAudit(Audit(1, "a", "flat"));
  store_->AddAudit(Audit(2, "a", "flat"));
  store_->AddAudit(Audit(2, "a", "flat", 422));
  store_->AddAudit(Audit(2, "b", "flat"));
  EXPECT_EQ(store_->BytesStoredSince("a", Time(milliseconds(2))), 100u);
  EXPECT_EQ(store_->BytesStoredSince("a", Time(milliseconds(0))), 200u);
  EXPECT_EQ(store_->BytesStoredSince("c", Time(milliseconds(0))), 0u);
}

}  // namespace
}  // namespace lares::store
