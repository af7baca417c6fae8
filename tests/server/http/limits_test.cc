// Connections that take their time, beside one that does not.
#include <gmock/gmock.h>

#include <memory>
#include <thread>
#include <vector>

#include "server/http/log.h"
#include "server/http/server.h"
#include "tests/server/http/raw_client.h"

namespace lares::http {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kHello = "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n";

class LimitsTest : public ::testing::Test {
 protected:
  LimitsTest() {
    SetLogLevel(LogLevel::kOff);
    options_.port = 0;
    options_.loop.threads = 4;
  }

  void Start() {
    Router router;
    router.Add({"GET",
                "/hello",
                "hello",
                [](const Request&) {
                  Response response;
                  response.body = "hello";
                  return response;
                },
                {},
                0});
    router.Add({"GET",
                "/some",
                "some",
                [](const Request&) {
                  Response response;
                  response.body = std::string(900'000, 's');
                  return response;
                },
                {},
                0});
    router.Add({"PUT",
                "/count",
                "count",
                [](const Request& request) {
                  Response response;
                  response.body = std::to_string(ReadWholeBody(request, 1u << 20).size());
                  return response;
                },
                {"*/*"},
                1u << 20});
    server_ = std::make_unique<Server>(std::make_shared<Service>(std::move(router)), options_);
  }

  std::unique_ptr<RawClient> Saying(const std::string& text) const {
    auto client = std::make_unique<RawClient>(server_->port());
    client->Say(text);
    return client;
  }
  // Soon, on a connection of its own.
  std::string Hello() const { return Saying(kHello)->Hear("\r\n\r\nhello", seconds(3)); }

  static std::string Put(int length) {
    return "PUT /count HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
           "text/plain\r\nContent-Length: " +
           std::to_string(length) + "\r\n\r\n";
  }

  ServerOptions options_;
  std::unique_ptr<Server> server_;
};

TEST_F(LimitsTest, HalfAShortBodyHoldsNoThread) {
  Start();
  std::vector<std::unique_ptr<RawClient>> halves;
  for (int i = 0; i < 40; ++i) halves.push_back(Saying(Put(1000) + "half"));
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
}

TEST_F(LimitsTest, AShortBodyMayComeInPiecesAndAnotherRequestBehindIt) {
  Start();
  const auto client = Saying(Put(10) + "01234");
  EXPECT_EQ(client->Hear("", milliseconds(100)), "");
  client->Say("56789" + Put(3) + "ab");
  EXPECT_THAT(client->Hear("\r\n\r\n10", seconds(3)), StartsWith("HTTP/1.1 200"));
  EXPECT_EQ(client->Hear("", milliseconds(100)), "");
  client->Say("c" + std::string(kHello));
  EXPECT_THAT(client->Hear("\r\n\r\nhello", seconds(3)), HasSubstr("\r\n\r\n3HTTP/1.1 200"));
}

TEST_F(LimitsTest, AShortBodyThatDoesNotComeEndsInTime) {
  options_.loop.limits.header_time = milliseconds(300);
  Start();
  const auto client = Saying(Put(1000) + "half");
  EXPECT_THAT(client->Hear("", seconds(5)), StartsWith("HTTP/1.1 408"));
  EXPECT_TRUE(client->closed());
}

TEST_F(LimitsTest, WhoWaitsToBeAskedForABodyIsAsked) {
  Start();
  std::string put = Put(4);
  put.insert(put.find("\r\n"), "\r\nExpect: 100-continue");
  const auto client = Saying(put);
  EXPECT_THAT(client->Hear("100 Continue", seconds(3)), StartsWith("HTTP/1.1 100"));
  client->Say("body");
  EXPECT_THAT(client->Hear("\r\n\r\n4", seconds(3)), HasSubstr("HTTP/1.1 200"));
}

TEST_F(LimitsTest, ClientsThatReadNothingDoNotHoldEveryThread) {
  Start();
  std::string many;
  for (int i = 0; i < 20; ++i) many += "GET /some HTTP/1.1\r\nHost: localhost\r\n\r\n";
  std::vector<std::unique_ptr<RawClient>> deaf;
  for (int i = 0; i < 12; ++i) deaf.push_back(Saying(many));
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
}

TEST_F(LimitsTest, ClientsThatAreRefusedAndStayDoNotHoldEveryThread) {
  Start();
  std::vector<std::unique_ptr<RawClient>> garbage;
  for (int i = 0; i < 40; ++i) garbage.push_back(Saying("\x01\x02garbage\r\n\r\n"));
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
}

TEST_F(LimitsTest, WhoOnlyConnectsDoesNotPushOutWhoAsks) {
  options_.loop.max_connections = 16;
  Start();
  const auto good = Saying(kHello);
  EXPECT_THAT(good->Hear("\r\n\r\nhello"), StartsWith("HTTP/1.1 200"));
  std::vector<std::unique_ptr<RawClient>> flood;
  for (int i = 0; i < 100; ++i) flood.push_back(Saying(i % 2 == 0 ? "" : "GET / HTTP/1.1\r\nX: "));
  good->Say(kHello);
  EXPECT_THAT(good->Hear("\r\n\r\nhello", seconds(3)), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
}

TEST_F(LimitsTest, ADribblingHeaderDoesNotMakeItsConnectionYounger) {
  options_.loop.max_connections = 2;
  Start();
  const auto slow = Saying("GET / HTTP/1.1\r\nX: ");
  std::this_thread::sleep_for(milliseconds(50));
  const auto silent = Saying("");
  std::this_thread::sleep_for(milliseconds(50));
  slow->Say("more");
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
  slow->Hear("", seconds(3));
  EXPECT_TRUE(slow->closed());
  silent->Hear("", milliseconds(100));
  EXPECT_FALSE(silent->closed());
}

TEST_F(LimitsTest, OneAddressHasNoMoreConnectionsThanItMay) {
  options_.loop.max_connections_per_peer = 3;
  Start();
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(Saying(kHello));
    EXPECT_THAT(clients.back()->Hear("\r\n\r\nhello"), StartsWith("HTTP/1.1 200"));
  }
  EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));  // the first made room
  clients[0]->Hear("", seconds(3));
  EXPECT_TRUE(clients[0]->closed());
  // What has ended counts no more.
  clients.clear();
  for (int i = 0; i < 10; ++i) EXPECT_THAT(Hello(), StartsWith("HTTP/1.1 200"));
}

}  // namespace
}  // namespace lares::http
