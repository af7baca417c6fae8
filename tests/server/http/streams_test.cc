// Answers without an end that is known: open bodies and event streams, over real sockets.
#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <mutex>
#include <thread>

#include "base/error.h"
#include "server/http/client.h"
#include "server/http/event_channel.h"
#include "server/http/log.h"
#include "server/http/server.h"
#include "tests/server/http/raw_client.h"

namespace lares::http {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <typename Condition>
bool Eventually(Condition condition, milliseconds time = seconds(5)) {
  for (const auto end = std::chrono::steady_clock::now() + time;
       std::chrono::steady_clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return condition();
}

class StreamsTest : public ::testing::Test {
 protected:
  StreamsTest() {
    SetLogLevel(LogLevel::kOff);
    options_.port = 0;
    options_.loop.threads = 4;
  }
  void TearDown() override {
    release_ = true;
    server_.reset();
  }

  void AddOpen(Router& router, const std::string& path, std::function<void(OpenSink&)> produce) {
    router.Add({"GET",
                path,
                path.substr(1),
                [produce](const Request&) {
                  Response response;
                  response.headers.Set("Content-Type", "text/plain");
                  response.body = OpenBody{produce};
                  return response;
                },
                {},
                0});
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
    AddOpen(router, "/lines", [](OpenSink& sink) {
      for (int i = 0; i < 3; ++i) sink.Write("line " + std::to_string(i) + "\n");
    });
    AddOpen(router, "/nothing", [](OpenSink&) {});
    AddOpen(router, "/slowly", [this](OpenSink& sink) {
      sink.Write("first\n");
      sink.Flush();
      Eventually([this] { return release_.load(); });
      sink.Write("second\n");
    });
    AddOpen(router, "/breaks", [](OpenSink& sink) {
      sink.Write("a little\n");
      sink.Flush();
      sink.Write("more\n");
      throw Error(Code::kIo, "the source is gone");
    });
    AddOpen(router, "/fails", [](OpenSink& sink) {
      sink.Write("a row that nobody needs to see");
      throw Error(Code::kTimeout, "it took longer than 1 s");
    });
    AddOpen(router, "/endless", [this](OpenSink& sink) {
      const std::string piece(1000, 'x');
      try {
        while (true) {
          sink.Write(piece);
          produced_ += piece.size();
        }
      } catch (const Error&) {
        ++ended_;
        throw;
      }
    });
    AddOpen(router, "/thinks", [this](OpenSink& sink) {
      const std::stop_token gone = sink.gone();
      ++thinking_;
      if (Eventually([&] { return gone.stop_requested() || release_; }, seconds(20))) ++ended_;
    });
    router.Add({"GET",
                "/ponders",
                "ponders",
                [this](const Request& request) {
                  const std::stop_token gone = request.WatchClient();
                  ++thinking_;
                  if (Eventually([&] { return gone.stop_requested() || release_; }, seconds(20))) {
                    ++ended_;
                  }
                  return Response{};
                },
                {},
                0});
    router.Add({"GET",
                "/events",
                "events",
                [this](const Request&) {
                  Response response;
                  response.headers.Set("Content-Type", "text/event-stream");
                  response.body = EventsBody{[this](std::shared_ptr<EventChannel> channel) {
                    channel->Send({"hello", "1", "you are in"});
                    const std::lock_guard lock(mutex_);
                    channels_.push_back(std::move(channel));
                  }};
                  return response;
                },
                {},
                0});
    server_ = std::make_unique<Server>(std::make_shared<Service>(std::move(router)), options_);
  }

  static std::string Ask(const std::string& path, const std::string& version = "1.1") {
    return "GET " + path + " HTTP/" + version + "\r\nHost: localhost\r\n\r\n";
  }
  std::unique_ptr<RawClient> Open(const std::string& path) {
    auto client = std::make_unique<RawClient>(server_->port());
    client->Say(Ask(path));
    return client;
  }
  std::size_t subscribers() {
    const std::lock_guard lock(mutex_);
    return channels_.size();
  }
  std::shared_ptr<EventChannel> channel(std::size_t i) {
    Eventually([&] { return subscribers() > i; });
    const std::lock_guard lock(mutex_);
    return channels_.at(i);
  }

  ServerOptions options_;
  std::atomic<bool> release_{false};
  std::atomic<std::uint64_t> produced_{0};
  std::atomic<int> thinking_{0};
  std::atomic<int> ended_{0};
  std::mutex mutex_;
  std::vector<std::shared_ptr<EventChannel>> channels_;
  std::unique_ptr<Server> server_;
};

TEST_F(StreamsTest, AShortOpenBodyHasALength) {
  Start();
  RawClient client(server_->port());
  client.Say(Ask("/lines"));
  EXPECT_THAT(client.Hear("line 2\n"),
              AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("Content-Length: 21\r\n"),
                    HasSubstr("Content-Type: text/plain\r\n"), Not(HasSubstr("chunked")),
                    EndsWith("\r\n\r\nline 0\nline 1\nline 2\n")));
  client.Say(Ask("/nothing") + Ask("/hello"));
  EXPECT_THAT(client.Hear("\r\n\r\nhello"), HasSubstr("Content-Length: 0\r\n"));
}

TEST_F(StreamsTest, ALongOpenBodyComesInChunksAndKeepsTheConnection) {
  Start();
  RawClient client(server_->port());
  for (int i = 0; i < 3; ++i) {
    client.Say(Ask("/slowly"));
    EXPECT_THAT(client.Hear("first\n\r\n"),
                AllOf(StartsWith("HTTP/1.1 200 OK\r\n"), Not(HasSubstr("Content-Length")),
                      HasSubstr("Transfer-Encoding: chunked\r\n"), HasSubstr("X-Request-Id: "),
                      EndsWith("\r\n\r\n6\r\nfirst\n\r\n")));
    release_ = true;
    EXPECT_EQ(client.Hear("\r\n0\r\n\r\n"), "7\r\nsecond\n\r\n0\r\n\r\n");
    release_ = false;
  }
}

TEST_F(StreamsTest, AnOpenBodyEndsWithTheConnectionInHttp10) {
  Start();
  release_ = true;
  RawClient client(server_->port());
  client.Say(Ask("/slowly", "1.0"));
  EXPECT_THAT(client.Hear(),
              AllOf(HasSubstr(" 200 "), Not(HasSubstr("Transfer-Encoding")),
                    HasSubstr("Connection: close\r\n"), Not(HasSubstr("Content-Length")),
                    EndsWith("\r\n\r\nfirst\nsecond\n")));
  EXPECT_TRUE(client.closed());
}

TEST_F(StreamsTest, AnOpenBodyEndsAConnectionThatItsClientWantsClosed) {
  Start();
  release_ = true;
  RawClient client(server_->port());
  client.Say("GET /slowly HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(client.Hear(), AllOf(HasSubstr("Connection: close\r\n"), EndsWith("0\r\n\r\n")));
  EXPECT_TRUE(client.closed());
}

TEST_F(StreamsTest, AnOpenBodyThatFailsBeforeItSaidAnythingIsAProblem) {
  Start();
  RawClient client(server_->port());
  for (int i = 0; i < 3; ++i) {
    client.Say(Ask("/fails"));
    EXPECT_THAT(client.Hear("}\n"),
                AllOf(StartsWith("HTTP/1.1 504"), HasSubstr("application/problem+json"),
                      HasSubstr("X-Request-Id: "), HasSubstr("\"code\": \"timeout\"")));
  }
}

TEST_F(StreamsTest, HeadOfAnOpenBodyProducesNothing) {
  Start();
  RawClient client(server_->port());
  client.Say("HEAD /endless HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(client.Hear(), AllOf(StartsWith("HTTP/1.1 200"), Not(HasSubstr("Content-Length")),
                                   EndsWith("\r\n\r\n")));
  EXPECT_EQ(produced_, 0u);
}

TEST_F(StreamsTest, WhatIsFlushedArrivesBeforeTheRest) {
  Start();
  RawClient client(server_->port());
  client.Say(Ask("/slowly"));
  EXPECT_THAT(client.Hear("first\n"), Not(HasSubstr("second")));
  release_ = true;
  EXPECT_THAT(client.Hear("\r\n0\r\n\r\n"), HasSubstr("second\n"));
}

TEST_F(StreamsTest, AnOpenBodyThatFailsIsNotPassedOffAsWhole) {
  Start();
  RawClient client(server_->port());
  client.Say(Ask("/breaks"));
  EXPECT_THAT(client.Hear(),
              AllOf(HasSubstr("a little\n"), HasSubstr("more\n"), Not(HasSubstr("\r\n0\r\n\r\n"))));
  EXPECT_TRUE(client.closed());
  Client reader(server_->url());
  EXPECT_THROW(reader.Send({"GET", "/breaks", {}, {}, {}}), Error);
}

TEST_F(StreamsTest, AClientThatDoesNotReadHoldsTheProducerBackAndIsGivenUp) {
  options_.loop.limits.stall_time = milliseconds(300);
  Start();
  const auto client = Open("/endless");
  ASSERT_TRUE(Eventually([&] { return produced_ > 0; }));
  EXPECT_TRUE(Eventually([&] { return ended_ == 1; }));
  EXPECT_LT(produced_, 32u << 20);  // what the two sockets' buffers hold
}

TEST_F(StreamsTest, TheSinkThrowsWhenTheClientHasGone) {
  Start();
  Open("/endless")->Hear("xxx");
  EXPECT_TRUE(Eventually([&] { return ended_ == 1; }));
}

TEST_F(StreamsTest, AProducerThatWritesNothingLearnsThatItsClientHasGone) {
  Start();
  auto client = Open("/thinks");
  ASSERT_TRUE(Eventually([&] { return thinking_ == 1; }));
  EXPECT_EQ(ended_, 0);
  client.reset();
  EXPECT_TRUE(Eventually([&] { return ended_ == 1; }));
}

TEST_F(StreamsTest, AHandlerLearnsThatItsClientHasGone) {
  Start();
  auto client = Open("/ponders");
  ASSERT_TRUE(Eventually([&] { return thinking_ == 1; }));
  EXPECT_EQ(ended_, 0);
  client.reset();
  EXPECT_TRUE(Eventually([&] { return ended_ == 1; }));
}

TEST_F(StreamsTest, AWatchedConnectionServesFurtherRequests) {
  Start();
  release_ = true;
  RawClient client(server_->port());
  for (int i = 0; i < 20; ++i) {
    client.Say(Ask("/ponders"));
    ASSERT_THAT(client.Hear("\r\n\r\n"), StartsWith("HTTP/1.1 200"));
    client.Say(Ask("/thinks"));
    ASSERT_THAT(client.Hear("\r\n\r\n"), StartsWith("HTTP/1.1 200"));
  }
}

TEST_F(StreamsTest, StoppingTellsAProducerThatThinksTooLong) {
  Start();
  const auto client = Open("/thinks");
  ASSERT_TRUE(Eventually([&] { return thinking_ == 1; }));
  EXPECT_FALSE(server_->Stop(milliseconds(50)));
  EXPECT_EQ(ended_, 1);
}

TEST_F(StreamsTest, OpenBodiesBeyondHalfOfTheThreadsAreToldToComeAgain) {
  Start();
  const auto a = Open("/thinks");
  const auto b = Open("/thinks");
  ASSERT_TRUE(Eventually([&] { return thinking_ == 2; }));
  EXPECT_THAT(Open("/thinks")->Hear("}\n"),
              AllOf(StartsWith("HTTP/1.1 503"), HasSubstr("Retry-After: 5\r\n")));
  EXPECT_THAT(Open("/hello")->Hear("hello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(StreamsTest, EventsReachTheClientAsTheyHappen) {
  Start();
  const auto client = Open("/events");
  EXPECT_THAT(client->Hear("\n\n"),
              AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("Content-Type: text/event-stream\r\n"),
                    HasSubstr("Transfer-Encoding: chunked\r\n"), Not(HasSubstr("Content-Length")),
                    HasSubstr("event: hello\nid: 1\ndata: you are in\n\n")));
  EXPECT_EQ(channel(0)->Send({"news", "2", "a\nb"}), EventChannel::Sent::kTaken);
  EXPECT_THAT(client->Hear("b\n\n"), HasSubstr("event: news\nid: 2\ndata: a\ndata: b\n\n"));
}

TEST_F(StreamsTest, EventStreamsHoldNoThread) {
  Start();
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 50; ++i) clients.push_back(Open("/events"));
  for (const auto& client : clients) {
    ASSERT_THAT(client->Hear("you are in\n\n"), StartsWith("HTTP/1.1 200"));
  }
  EXPECT_THAT(Open("/hello")->Hear("hello"), StartsWith("HTTP/1.1 200"));
  for (std::size_t i = 0; i < clients.size(); ++i) {
    channel(i)->Send({"", "", std::to_string(i)});
  }
  // Channels are in no particular order of clients.
  for (const auto& client : clients) EXPECT_THAT(client->Hear("\n\n"), HasSubstr("data: "));
}

TEST_F(StreamsTest, EventStreamsBeyondTheirNumberAreRefusedUntilOneEnds) {
  options_.loop.max_event_streams = 2;
  Start();
  auto a = Open("/events");
  const auto b = Open("/events");
  a->Hear("\n\n");
  b->Hear("\n\n");
  EXPECT_THAT(Open("/events")->Hear("}\n"),
              AllOf(StartsWith("HTTP/1.1 503"), HasSubstr("Retry-After: 5\r\n"),
                    HasSubstr("\"code\": \"unavailable\""), HasSubstr("event stream")));
  a.reset();
  EXPECT_TRUE(Eventually([&] {
    return Open("/events")->Hear("you are in\n\n", milliseconds(200)).starts_with("HTTP/1.1 200");
  }));
}

TEST_F(StreamsTest, AChannelKnowsThatItsClientHasGone) {
  Start();
  auto client = Open("/events");
  client->Hear("\n\n");
  EXPECT_FALSE(channel(0)->gone());
  client.reset();
  EXPECT_TRUE(Eventually([&] { return channel(0)->gone(); }));
  EXPECT_EQ(channel(0)->Send({"", "", "x"}), EventChannel::Sent::kGone);
}

TEST_F(StreamsTest, ASlowReaderGetsNoSecondEventBeforeTheFirst) {
  Start();
  const auto client = Open("/events");
  client->Hear("\n\n");
  const std::string large(16 << 20, 'l');
  ASSERT_EQ(channel(0)->Send({"", "", large}), EventChannel::Sent::kTaken);
  EXPECT_FALSE(channel(0)->drained());
  EXPECT_EQ(channel(0)->Send({"", "", "small"}), EventChannel::Sent::kBusy);
  EXPECT_GT(client->Hear("l\n\n", seconds(20)).size(), large.size());
  EXPECT_TRUE(Eventually([&] { return channel(0)->drained(); }));
  EXPECT_EQ(channel(0)->Send({"", "", "small"}), EventChannel::Sent::kTaken);
}

TEST_F(StreamsTest, AReaderThatStandsStillIsGivenUp) {
  options_.loop.channels.stall_time = milliseconds(200);
  Start();
  const auto client = Open("/events");
  client->Hear("\n\n");
  channel(0)->Send({"", "", std::string(16 << 20, 'l')});
  EXPECT_TRUE(Eventually([&] { return channel(0)->gone(); }));
}

TEST_F(StreamsTest, AnIdleStreamIsKeptAliveByComments) {
  options_.loop.channels.keep_alive = milliseconds(100);
  options_.loop.limits.idle_time = milliseconds(150);
  Start();
  const auto client = Open("/events");
  client->Hear("you are in\n\n");
  EXPECT_THAT(client->Hear(":\n\n"), HasSubstr("\r\n:\n\n"));
  EXPECT_THAT(client->Hear(":\n\n"), HasSubstr("\r\n:\n\n"));
  EXPECT_FALSE(channel(0)->gone());
}

TEST_F(StreamsTest, StopEndsEventStreamsAtOnceAndWhole) {
  Start();
  const auto client = Open("/events");
  client->Hear("you are in\n\n");
  const auto before = std::chrono::steady_clock::now();
  EXPECT_TRUE(server_->Stop(seconds(10)));
  EXPECT_LT(std::chrono::steady_clock::now() - before, seconds(5));
  EXPECT_THAT(client->Hear(), EndsWith("0\r\n\r\n"));
  EXPECT_EQ(channel(0)->Send({"", "", "late"}), EventChannel::Sent::kGone);
}

TEST_F(StreamsTest, ASubscriptionThatFailsEndsTheStream) {
  Router router;
  router.Add({"GET",
              "/events",
              "events",
              [](const http::Request&) {
                Response response;
                response.body = EventsBody{[](const std::shared_ptr<EventChannel>&) {
                  throw Error(Code::kInternal, "no room");
                }};
                return response;
              },
              {},
              0});
  server_ = std::make_unique<Server>(std::make_shared<Service>(std::move(router)), options_);
  const auto client = Open("/events");
  client->Hear();
  EXPECT_TRUE(client->closed());
}

TEST_F(StreamsTest, TheClientReadsAnAnswerLineByLineAsItComes) {
  Start();
  Client client(server_->url());
  std::vector<std::string> lines;
  LineReader reader([&](std::string_view line) {
    lines.emplace_back(line);
    release_ = true;  // the rest comes only after the first line was read
  });
  Transfer transfer;
  transfer.sink = [&](std::string_view piece) { reader.Feed(piece); };
  EXPECT_EQ(client.Send({"GET", "/slowly", {}, {}, {}}, transfer).status, 200);
  EXPECT_THAT(lines, ElementsAre("first", "second"));
}

TEST_F(StreamsTest, TheClientReadsEventsAndLeavesWhenItHasEnough) {
  Start();
  Client client(server_->url());
  std::vector<std::string> seen;
  struct Enough {};
  EventReader reader([&](const Event& event) {
    seen.push_back(event.event + "/" + event.id + "/" + event.data);
    if (event.event == "last") throw Enough{};
  });
  std::thread([this] { channel(0)->Send({"last", "", "bye"}); }).detach();
  Transfer transfer;
  transfer.sink = [&](std::string_view piece) { reader.Feed(piece); };
  EXPECT_THROW(client.Send({"GET", "/events", {}, {}, {}}, transfer), Enough);
  EXPECT_THAT(seen, ElementsAre("hello/1/you are in", "last//bye"));
}

}  // namespace
}  // namespace lares::http
