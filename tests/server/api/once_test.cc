// Idempotency-Key over HTTP.
#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "server/store/idempotency.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

class OnceTest : public ApiTest {
 protected:
  http::ClientResponse PutVersion(const std::string& key, const std::string& text = kTurtle,
                                  const std::string& note = "a note") {
    return SendForm("POST", "/v1/environments/lab/versions",
                    {{"semantic", text, {}, "room.ttl", "text/turtle"}, {"note", note, {}, "", ""}},
                    "Idempotency-Key", key);
  }
  http::ClientResponse PutRobot(const std::string& key, const std::string& id = "scout",
                                const std::string& text = kTurtle) {
    return Send("PUT", "/v1/robots/" + id, "text/turtle", text, "Idempotency-Key", key);
  }
  int Versions() { return store_->GetVersion("lab", 0).number; }
};

TEST_F(OnceTest, TheSameRequestIsAnsweredAgainAndNothingIsWritten) {
  const auto first = PutVersion("k1");
  ASSERT_EQ(first.status, 201) << first.body;
  EXPECT_FALSE(first.headers.Has("Idempotency-Replayed"));
  const auto again = PutVersion("\"k1\"");  // as a structured field; another boundary lies between
  EXPECT_EQ(again.status, 201);
  EXPECT_EQ(again.body, first.body);
  for (const char* header : {"ETag", "Location", "Content-Type"}) {
    EXPECT_EQ(again.headers.Get(header), first.headers.Get(header));
  }
  EXPECT_EQ(again.headers.Get("Idempotency-Replayed"), "true");
  EXPECT_NE(again.headers.Get("X-Request-Id"), first.headers.Get("X-Request-Id"));
  EXPECT_EQ(Versions(), 1);
  EXPECT_EQ(PutVersion("k2").status, 201);
  EXPECT_EQ(Versions(), 2);
}

TEST_F(OnceTest, TheAnswerOutlivesTheServer) {
  const auto first = PutVersion("k1");
  client_.reset();
  server_.reset();
  context_.reset();
  knowledge_.reset();
  store_.reset();
  store_ = store::OpenSqliteStore({folder_ / "data"});
  knowledge_ = std::make_unique<server::Knowledge>(*store_, engines_);
  context_ = std::make_unique<api::Context>(api::Context{*store_, *knowledge_});
  http::ServerOptions options;
  options.port = 0;
  server_ = std::make_unique<http::Server>(api::MakeService(*context_), options);
  client_ = std::make_unique<http::Client>(server_->url());
  EXPECT_EQ(PutVersion("k1").body, first.body);
  EXPECT_EQ(Versions(), 1);
}

TEST_F(OnceTest, AKeyOfAnotherRequestIsRefused) {
  ASSERT_EQ(PutVersion("k1").status, 201);
  for (const auto& other : {PutVersion("k1", "<urn:a> <urn:b> <urn:other> .\n"),
                            PutVersion("k1", kTurtle, "b note"), PutRobot("k1"),
                            Send("PUT", "/v1/robots/scout?recover=true", "text/turtle", kTurtle,
                                 "Idempotency-Key", "k1")}) {
    EXPECT_EQ(other.status, 422);
    EXPECT_EQ(Json(other)["code"], "idempotency-key-reused");
  }
  EXPECT_EQ(Versions(), 1);
  EXPECT_FALSE(store_->FindDocument(store::DocumentKind::kRobot, "scout"));
}

TEST_F(OnceTest, DocumentsAreCoveredToo) {
  const auto first = PutRobot("k");
  EXPECT_EQ(first.status, 201);
  EXPECT_EQ(PutRobot("other", "scout", "<urn:a> <urn:b> <urn:d> .\n").status, 200);
  EXPECT_EQ(PutRobot("k").body, first.body);  // not put back
  EXPECT_EQ(store_->FindDocument(store::DocumentKind::kRobot, "scout")->version, 2);
}

TEST_F(OnceTest, ARefusedRequestFreesItsKey) {
  EXPECT_EQ(PutRobot("k", "scout", "malformed").status, 422);
  EXPECT_EQ(PutRobot("k").status, 201);
}

TEST_F(OnceTest, ARequestUnderWayIsNotDoneTwice) {
  std::mutex mutex;
  std::condition_variable changed;
  bool begun = false;
  bool go_on = false;
  Answers().put = [&](const server::PutRequest& put, store::Store& store) {
    std::unique_lock lock(mutex);
    begun = true;
    changed.notify_all();
    changed.wait(lock, [&] { return go_on; });
    server::PutAnswer answer;
    answer.document = store.PutDocument(
        {put.kind, put.id, "text/turtle", put.file_name, put.bytes, "{}", {}, ""});
    return answer;
  };
  http::ClientResponse first;
  std::thread slow([&] {
    http::Client client(server_->url());
    http::ClientRequest request{"PUT", "/v1/robots/scout", {}, {}, std::string(kTurtle)};
    request.headers.Set("Content-Type", "text/turtle");
    request.headers.Set("Idempotency-Key", "k");
    first = client.Send(request);
  });
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return begun; });
  }
  const auto second = PutRobot("k");
  {
    const std::lock_guard lock(mutex);
    go_on = true;
  }
  changed.notify_all();
  slow.join();
  EXPECT_EQ(second.status, 409);
  EXPECT_EQ(Json(second)["code"], "request-in-progress");
  EXPECT_EQ(second.headers.Get("Retry-After"), "1");
  EXPECT_EQ(first.status, 201);
  EXPECT_EQ(PutRobot("k").body, first.body);
}

// The process ended after the version was written and before its answer was kept.
TEST_F(OnceTest, AVersionThatWasWrittenWithoutAnAnswerIsNotWrittenAgain) {
  ASSERT_EQ(PutVersion("k1").status, 201);
  const std::string fingerprint = store_->idempotency_keys().Take("k1").fingerprint;
  ASSERT_EQ(store_->idempotency_keys().Take("k2").state, store::KeyRecord::State::kNew);
  store::NewVersion version;
  version.environment = "lab";
  version.note = "by the process that ended";
  version.request_key = "k2";
  version.request_fingerprint = fingerprint;
  store_->PutVersion(version);
  const auto again = PutVersion("k2");
  EXPECT_EQ(again.status, 201) << again.body;
  EXPECT_EQ(again.headers.Get("Idempotency-Replayed"), "true");
  EXPECT_EQ(again.headers.Get("ETag"), "\"lab-2\"");
  EXPECT_EQ(Json(again)["version"]["note"], "by the process that ended");
  EXPECT_EQ(PutVersion("k2", "<urn:a> <urn:b> <urn:other> .\n").status, 422);
  EXPECT_EQ(Versions(), 2);
}

TEST_F(OnceTest, KeysAreShortVisibleText) {
  for (const std::string& key :
       {std::string("\"\""), std::string("a b"), std::string(256, 'k'), std::string("\xc3\xa4")}) {
    EXPECT_EQ(PutRobot(key).status, 422) << key;
  }
  EXPECT_EQ(PutRobot(std::string(255, 'k')).status, 201);
}

}  // namespace
}  // namespace lares::testing
