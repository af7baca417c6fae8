#include <gmock/gmock.h>

#include <mutex>
#include <thread>

#include "base/error.h"
#include "server/http/events.h"
#include "server/http/url.h"
#include "tests/server/api/api_fixture.h"
#include "tests/server/http/raw_client.h"

namespace lares::testing {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <typename Condition>
bool Eventually(Condition condition) {
  for (int i = 0; i < 2500 && !condition(); ++i) std::this_thread::sleep_for(milliseconds(2));
  return condition();
}

class WatchesTest : public ApiTest {
 protected:
  WatchesTest() {
    Answers().view = [this](const server::ViewRequest& about) {
      ++views_;
      const std::lock_guard lock(mutex_);
      if (about.environment == "nowhere" || is_gone_) {
        throw Error(Code::kNotFound, "no environment is called '" + about.environment + "'");
      }
      return view_;
    };
    server_.reset();
    http::ServerOptions options;
    options.port = 0;
    options.loop.threads = 4;
    options.loop.max_event_streams = 40;
    server_ = std::make_unique<http::Server>(api::MakeService(*context_), options);
    client_ = std::make_unique<http::Client>(server_->url());
    Commit("cup1 a :Cup");
  }
  ~WatchesTest() override {
    server_.reset();
    context_.reset();  // the hub asks no more
    Answers() = {};
  }

  void Commit(const std::string& facts) {
    rdf::View next = ViewOfTurtle("@prefix : <https://w3id.org/lares#> . :" + facts + " .");
    {
      const std::lock_guard lock(mutex_);
      view_ = std::move(next);
    }
    knowledge_->changes().Notify();
  }
  std::unique_ptr<http::RawClient> Watch(const std::string& parameters) {
    auto client = std::make_unique<http::RawClient>(server_->port());
    client->Say("GET /v1/watches?" + parameters + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    return client;
  }
  static std::string Cups() {
    return "query=" + http::PercentEncode("SELECT ?c { ?c a lares:Cup }");
  }
  // The data of the one event in `heard`.
  static nlohmann::json Data(const std::string& heard) {
    const std::size_t at = heard.find("data: ");
    if (at == std::string::npos) return nullptr;
    return nlohmann::json::parse(heard.substr(at + 6, heard.find('\n', at) - at - 6));
  }
  static std::string Iri(const std::string& name) { return "https://w3id.org/lares#" + name; }

  std::mutex mutex_;
  rdf::View view_ = ViewOfTurtle("");
  bool is_gone_ = false;
  std::atomic<int> views_{0};
};

TEST_F(WatchesTest, TheAnswerThatStandsComesFirstThenWhatCommitsChange) {
  const auto client = Watch(Cups());
  const std::string first = client->Hear("\n\n", seconds(1));
  EXPECT_THAT(first, AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("event: answer\nid: 1\n")));
  EXPECT_EQ(Data(first)["count"], 1);
  EXPECT_EQ(Data(first)["rows"][0]["c"]["value"], Iri("cup1"));
  Commit("cup1 a :Cup . :cup2 a :Cup");
  const std::string second = client->Hear("\n\n", seconds(1));
  EXPECT_THAT(second, HasSubstr("event: change\nid: 2\n"));
  EXPECT_EQ(Data(second)["generation"], 2);
  EXPECT_EQ(Data(second)["count"], 2);
  EXPECT_EQ(Data(second)["added"][0]["c"]["value"], Iri("cup2"));
  EXPECT_EQ(Data(second)["removed"].size(), 0u);
  Commit("cup2 a :Cup");
  const nlohmann::json third = Data(client->Hear("\n\n", seconds(1)));
  EXPECT_EQ(third["added"].size(), 0u);
  EXPECT_EQ(third["removed"][0]["c"]["value"], Iri("cup1"));
}

TEST_F(WatchesTest, ACommitThatChangesNothingOfTheAnswerIsNotTold) {
  const auto client = Watch(Cups());
  client->Hear("\n\n", seconds(1));
  Commit("cup1 a :Cup . :plate1 a :Plate");
  knowledge_->changes().Notify();
  EXPECT_EQ(client->Hear("\n\n", milliseconds(500)), "");
}

TEST_F(WatchesTest, TheFirstEventMaySayTheCountAlone) {
  const nlohmann::json data = Data(Watch(Cups() + "&first=count")->Hear("\n\n", seconds(1)));
  EXPECT_EQ(data["count"], 1);
  EXPECT_EQ(data["digest"].get<std::string>().size(), 64u);
  EXPECT_FALSE(data.contains("rows"));
}

TEST_F(WatchesTest, APatternAnAskAndAConstructAreWatchedToo) {
  const auto pattern = Watch("predicate=rdf:type&object=lares:Cup");
  EXPECT_EQ(Data(pattern->Hear("\n\n", seconds(1)))["rows"][0]["subject"]["value"], Iri("cup1"));
  const auto ask = Watch("subject=lares:cup2&predicate=rdf:type&object=lares:Cup");
  EXPECT_EQ(Data(ask->Hear("\n\n", seconds(1)))["rows"][0]["boolean"], false);
  const auto construct =
      Watch("query=" + http::PercentEncode("CONSTRUCT { ?c a lares:Thing } { ?c a lares:Cup }"));
  EXPECT_EQ(Data(construct->Hear("\n\n", seconds(1)))["rows"][0]["object"]["value"], Iri("Thing"));
  Commit("cup2 a :Cup");
  EXPECT_EQ(Data(ask->Hear("\n\n", seconds(1)))["added"][0]["boolean"], true);
  EXPECT_EQ(Data(pattern->Hear("\n\n", seconds(1)))["added"][0]["subject"]["value"], Iri("cup2"));
}

TEST_F(WatchesTest, WhatCannotBeWatchedIsRefusedAtOnce) {
  EXPECT_EQ(Get("/v1/watches").status, 400);
  EXPECT_EQ(Get("/v1/watches?query=SELECT").status, 422);
  EXPECT_EQ(Get("/v1/watches?subject=%7B").status, 422);
  EXPECT_EQ(Get("/v1/watches?" + Cups() + "&first=all").status, 422);
  EXPECT_EQ(Get("/v1/watches?" + Cups() + "&environment=nowhere").status, 404);
}

TEST_F(WatchesTest, ManyWatchOneQueryThatIsAskedOnceForAll) {
  std::vector<std::unique_ptr<http::RawClient>> clients;
  for (int i = 0; i < 40; ++i) clients.push_back(Watch(Cups()));
  for (const auto& client : clients) {
    ASSERT_THAT(client->Hear("\n\n", seconds(2)), HasSubstr("event: answer"));
  }
  EXPECT_THAT(Get("/metrics").body, HasSubstr("lares_watch_subscribers 40\n"));
  const int before = views_;
  Commit("cup2 a :Cup");
  for (const auto& client : clients) {
    ASSERT_THAT(client->Hear("\n\n", seconds(2)), HasSubstr("event: change"));
  }
  EXPECT_EQ(views_ - before, 1);
}

TEST_F(WatchesTest, AClientThatDisappearsFreesItsPlace) {
  std::vector<std::unique_ptr<http::RawClient>> clients;
  for (int i = 0; i < 40; ++i) clients.push_back(Watch(Cups()));
  for (const auto& client : clients) client->Hear("\n\n", seconds(2));
  EXPECT_THAT(Watch(Cups())->Hear("}\n", seconds(1)), StartsWith("HTTP/1.1 503"));
  clients.clear();
  EXPECT_TRUE(Eventually(
      [&] { return Watch(Cups())->Hear("\n\n", milliseconds(200)).starts_with("HTTP/1.1 200"); }));
  EXPECT_TRUE(Eventually([&] { return context_->watches->subscribers() <= 1; }));
}

TEST_F(WatchesTest, DifferentQueriesAreLimitedAndTheirPlacesComeBack) {
  std::vector<std::shared_ptr<void>> places;
  for (int i = 0; i < 64; ++i) places.push_back(context_->watches->Reserve(std::to_string(i)));
  EXPECT_EQ(Get("/v1/watches?" + Cups()).status, 503);
  EXPECT_NO_THROW(context_->watches->Reserve("7"));
  places.pop_back();
  EXPECT_THAT(Watch(Cups())->Hear("\n\n", seconds(1)), StartsWith("HTTP/1.1 200"));
}

TEST_F(WatchesTest, CommitsInAHurryMakeOneEvent) {
  const auto client = Watch(Cups());
  client->Hear("\n\n", seconds(1));
  std::string facts = "cup1 a :Cup";
  for (int i = 2; i < 10; ++i) Commit(facts += " . :cup" + std::to_string(i) + " a :Cup");
  const std::string heard = client->Hear("\"count\":9", seconds(1));
  EXPECT_LE(std::count(heard.begin(), heard.end(), '{'), 60);
  EXPECT_THAT(heard, Not(HasSubstr("\"count\":5")));
}

TEST_F(WatchesTest, AWatchWhoseEnvironmentDisappearsEndsWithAnError) {
  const auto client = Watch(Cups());
  client->Hear("\n\n", seconds(1));
  {
    const std::lock_guard lock(mutex_);
    is_gone_ = true;
  }
  knowledge_->changes().Notify();
  EXPECT_THAT(client->Hear(), AllOf(HasSubstr("event: error\n"), HasSubstr("\"not-found\""),
                                    ::testing::EndsWith("0\r\n\r\n")));
  EXPECT_TRUE(client->closed());
}

TEST_F(WatchesTest, AnAnswerTooLargeToBeWatchedIsRefused) {
  std::string facts = "s :p 0";
  for (int i = 1; i < 150; ++i) facts += ", " + std::to_string(i);
  Commit(facts);
  const auto client = Watch("query=" + http::PercentEncode("SELECT * { ?a ?b ?c . ?d ?e ?f }"));
  EXPECT_THAT(client->Hear("}\n\n", seconds(5)), HasSubstr("\"too-large\""));
}

TEST_F(WatchesTest, TheServersEndEndsEveryStreamAtOnce) {
  const auto client = Watch(Cups());
  client->Hear("\n\n", seconds(1));
  EXPECT_TRUE(server_->Stop(seconds(10)));
  EXPECT_THAT(client->Hear(), ::testing::EndsWith("0\r\n\r\n"));
}

}  // namespace
}  // namespace lares::testing
