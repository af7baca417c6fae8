#include "server/http/server.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <future>
#include <thread>

#include "base/error.h"
#include "server/http/client.h"
#include "server/http/log.h"
#include "server/http/problem.h"
#include "tests/server/http/raw_client.h"

namespace lares::http {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Response Text(std::string text) {
  Response response;
  response.headers.Set("Content-Type", "text/plain");
  response.body = std::move(text);
  return response;
}

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    SetLogLevel(LogLevel::kOff);
    options_.port = 0;
    options_.loop.threads = 4;
  }

  void Start() {
    Router router;
    router.Add({"GET", "/hello", "hello", [](const Request&) { return Text("hello"); }, {}, 0});
    router.Add({"GET",
                "/slow",
                "slow",
                [this](const Request&) {
                  ++slow_running_;
                  std::this_thread::sleep_for(slow_time_);
                  return Text("slow but done");
                },
                {},
                0});
    router.Add({"GET",
                "/throws",
                "throws",
                [](const Request&) -> Response { throw std::runtime_error("unforeseen"); },
                {},
                0});
    router.Add({"GET",
                "/stream",
                "stream",
                [](const Request&) {
                  Response response;
                  response.body = StreamBody{300'000, [](const Sink& sink) {
                                               for (int i = 0; i < 300; ++i) {
                                                 sink(std::string(1000, 's'));
                                               }
                                             }};
                  return response;
                },
                {},
                0});
    router.Add({"GET",
                "/breaks",
                "breaks",
                [](const Request&) {
                  Response response;
                  response.body = StreamBody{1000, [](const Sink& sink) {
                                               sink("a little");
                                               throw Error(Code::kIo, "the disk is gone");
                                             }};
                  return response;
                },
                {},
                0});
    router.Add({"GET",
                "/file",
                "file",
                [this](const Request&) {
                  Response response;
                  response.headers.Set("Accept-Ranges", "bytes");
                  response.headers.Set("ETag", "\"f1\"");
                  response.headers.Set("Content-Type", "text/plain");
                  response.body = FileBody{file_, 0, 10};
                  return response;
                },
                {},
                0});
    router.Add({"PUT",
                "/count",
                "count",
                [](const Request& request) {
                  std::uint64_t bytes = 0;
                  request.read_body([&](std::string_view piece) { bytes += piece.size(); });
                  return Text(std::to_string(bytes));
                },
                {"*/*"},
                1u << 30});
    router.Add({"PUT",
                "/small",
                "small",
                [](const Request& request) { return Text(ReadWholeBody(request, 10)); },
                {"text/plain"},
                10});
    router.Add({"PUT",
                "/ignores",
                "ignores",
                [](const Request&) { return Text("no matter"); },
                {"*/*"},
                1u << 30});
    server_ = std::make_unique<Server>(std::make_shared<Service>(std::move(router)), options_);
  }

  void SetUp() override {
    file_ = ::testing::TempDir() + "lares_server_test_" + std::to_string(::getpid());
    std::ofstream(file_) << "0123456789";
  }
  void TearDown() override {
    server_.reset();
    std::remove(file_.c_str());
  }

  std::string Ask(const std::string& request) {
    RawClient client(server_->port());
    client.Say(request);
    return client.Hear();
  }
  // One request with the headers that every one needs.
  std::string Get(const std::string& path, const std::string& more = "") {
    return Ask("GET " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + more +
               "\r\n");
  }

  ServerOptions options_;
  std::unique_ptr<Server> server_;
  std::string file_;
  std::atomic<int> slow_running_{0};
  milliseconds slow_time_{300};
};

TEST_F(ServerTest, AnswersAGetOverARealSocket) {
  Start();
  const std::string answer = Get("/hello", "X-Request-Id: mine-1\r\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(answer, HasSubstr("X-Request-Id: mine-1\r\n"));
  EXPECT_THAT(answer, ::testing::EndsWith("\r\n\r\nhello"));
}

TEST_F(ServerTest, KeepsAConnectionOpenForManyRequests) {
  Start();
  RawClient client(server_->port());
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(client.Say("GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    ASSERT_THAT(client.Hear("\r\n\r\nhello"), StartsWith("HTTP/1.1 200"));
  }
}

TEST_F(ServerTest, AnswersRequestsSentInOneGo) {
  Start();
  RawClient client(server_->port());
  const std::string one = "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n";
  client.Say(one + one + "GET /hello HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  const std::string heard = client.Hear();
  std::size_t answers = 0;
  for (std::size_t at = heard.find("HTTP/1.1 200"); at != std::string::npos;
       at = heard.find("HTTP/1.1 200", at + 1)) {
    ++answers;
  }
  EXPECT_EQ(answers, 3u);
}

TEST_F(ServerTest, AnswersHeadWithLengthAndWithoutBody) {
  Start();
  const std::string answer =
      Ask("HEAD /file HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(answer,
              AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("Content-Length: 10\r\n"),
                    HasSubstr("Accept-Ranges: bytes\r\n"), ::testing::EndsWith("\r\n\r\n")));
}

TEST_F(ServerTest, HeadClaimsNoRangesWhereGetHasNone) {
  Start();
  EXPECT_THAT(Ask("HEAD /hello HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("Content-Length: 5\r\n"),
                    Not(HasSubstr("Accept-Ranges"))));
}

TEST_F(ServerTest, ServesARangeOfAFile) {
  Start();
  const std::string answer = Get("/file", "Range: bytes=2-4\r\n");
  EXPECT_THAT(answer,
              AllOf(StartsWith("HTTP/1.1 206"), HasSubstr("Content-Range: bytes 2-4/10"),
                    HasSubstr("Content-Length: 3\r\n"), ::testing::EndsWith("\r\n\r\n234")));
}

TEST_F(ServerTest, IgnoresARangeThatCannotBeRead) {
  Start();
  for (const char* range : {"Range: lines=1-2\r\n", "Range: bytes=5-1\r\n", "range: what\r\n"}) {
    EXPECT_THAT(Get("/file", range),
                AllOf(StartsWith("HTTP/1.1 200"), ::testing::EndsWith("0123456789")))
        << range;
  }
}

TEST_F(ServerTest, DoesNotSliceWhatHasNoRanges) {
  Start();
  EXPECT_THAT(Get("/hello", "Range: bytes=1-2\r\n"),
              AllOf(StartsWith("HTTP/1.1 200"), ::testing::EndsWith("\r\n\r\nhello")));
}

TEST_F(ServerTest, AnswersARangeBehindTheEndWith416) {
  Start();
  EXPECT_THAT(Get("/file", "Range: bytes=10-\r\n"),
              AllOf(StartsWith("HTTP/1.1 416"), HasSubstr("Content-Range: bytes */10"),
                    HasSubstr("range-not-satisfiable")));
}

TEST_F(ServerTest, AnswersAKnownETagWith304) {
  Start();
  EXPECT_THAT(Get("/file", "If-None-Match: \"x\", W/\"f1\"\r\n"),
              AllOf(StartsWith("HTTP/1.1 304"), HasSubstr("ETag: \"f1\"\r\n"),
                    Not(HasSubstr("Content-Length")), Not(HasSubstr("\nContent-Type")),
                    ::testing::EndsWith("\r\n\r\n")));
}

TEST_F(ServerTest, RefusesAForeignHost) {
  Start();
  EXPECT_THAT(Ask("GET /hello HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 403"), HasSubstr("\"code\": \"forbidden\"")));
}

TEST_F(ServerTest, TurnsAnUnforeseenExceptionIntoAProblem) {
  Start();
  EXPECT_THAT(Get("/throws"),
              AllOf(StartsWith("HTTP/1.1 500"), HasSubstr("application/problem+json"),
                    HasSubstr("\"code\": \"internal\"")));
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, RefusesWhatIsNoHttpAndLives) {
  Start();
  for (const char* garbage :
       {"\r\n\r\n", "nonsense\r\n\r\n", "GET\r\n\r\n", "FLY /hello HTTP/1.1\r\nHost: a\r\n\r\n",
        "\x16\x03\x01\x02\r\n\r\n"}) {
    EXPECT_THAT(Ask(garbage), StartsWith("HTTP/1.1 400")) << garbage;
  }
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, RefusesABodyOfTwoLengths) {
  Start();
  const std::string head = "PUT /count HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n";
  EXPECT_THAT(Ask(head + "Content-Length: 3\r\nContent-Length: 4\r\n\r\nabcd"),
              StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(Ask(head + "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n"),
              StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(Ask(head + "Content-Length: -1\r\n\r\n"), StartsWith("HTTP/1.1 400"));
}

TEST_F(ServerTest, HeaderThatTwoReadersCouldReadDifferentlyEndsTheConnection) {
  Start();
  const std::string next = "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n";
  const std::string nul = std::string("X-A: b") + '\0' + "c";
  for (const std::string& field :
       {std::string("Content-Length : 3"), std::string("Content-Length: 3\r\nContent-Length: 3"),
        std::string("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked"),
        std::string("Transfer-Encoding: identity, chunked"), std::string("X-A: b\r\n folded"),
        std::string("X-A: b\rX-B: c"), std::string("X-A: b\nX-B: c"), std::string("X A: b"),
        std::string("Content-Length: -5"), std::string("Transfer-Encoding:"),
        std::string("Origin:"), std::string(": b"), std::string("no colon"), nul,
        std::string("Content-Length: 3\r\nTransfer-Encoding: chunked")}) {
    RawClient client(server_->port());
    client.Say("PUT /count HTTP/1.1\r\nHost: localhost\r\n" + field + "\r\n\r\n" + next);
    client.FinishSaying();
    EXPECT_THAT(client.Hear(), AllOf(StartsWith("HTTP/1.1 400"), HasSubstr("Connection: close"),
                                     Not(HasSubstr("HTTP/1.1 200"))))
        << field;
  }
}

TEST_F(ServerTest, MalformedChunksEndTheConnection) {
  options_.loop.threads = 16;  // the answer is read before its thread is free again
  Start();
  for (const char* body :
       {"-5\r\nabcde\r\n0\r\n\r\n", "0x5\r\nabcde\r\n0\r\n\r\n", " 5\r\nabcde\r\n0\r\n\r\n",
        "5\nabcde\r\n0\r\n\r\n", "5\r\nabcdeXX0\r\n\r\n", "5 \r\nabcde\r\n0\r\n\r\n", "\r\n\r\n",
        "fffffffffffffffff\r\nabc"}) {
    RawClient client(server_->port());
    client.Say(
        std::string("PUT /count HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n"
                    "\r\n") +
        body + "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n");
    client.FinishSaying();
    EXPECT_THAT(client.Hear(), AllOf(StartsWith("HTTP/1.1 400"), HasSubstr("Connection: close"),
                                     Not(HasSubstr("HTTP/1.1 200"))))
        << body;
  }
  EXPECT_THAT(Ask("PUT /count HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n"
                  "Transfer-Encoding: chunked\r\n\r\n5;a=b\r\nabcde\r\n0\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 200"), ::testing::EndsWith("\r\n\r\n5")));
}

TEST_F(ServerTest, SlowUploadsBeyondHalfOfTheThreadsAreToldToComeAgain) {
  Start();
  std::vector<std::unique_ptr<RawClient>> slow;
  const std::string upload = "PUT /count HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100000\r\n";
  for (int i = 0; i < 2; ++i) {
    slow.push_back(std::make_unique<RawClient>(server_->port()));
    slow.back()->Say(upload + "Expect: 100-continue\r\n\r\n");
    EXPECT_THAT(slow.back()->Hear("\r\n\r\n"), StartsWith("HTTP/1.1 100"));
  }
  for (int i = 0; i < 5; ++i) {
    RawClient more(server_->port());
    more.Say(upload + "\r\n");
    EXPECT_THAT(more.Hear("\r\n\r\n"),
                AllOf(StartsWith("HTTP/1.1 503"), HasSubstr("Retry-After: 5\r\n")));
  }
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
  slow[0]->Say(std::string(100'000, 'x'));
  EXPECT_THAT(slow[0]->Hear("\r\n\r\n100000"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, GivesUpOnABodyThatDribbles) {
  options_.loop.limits.stall_time = milliseconds(150);
  Start();
  RawClient client(server_->port());
  client.Say("PUT /count HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100000\r\n\r\n");
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < seconds(5) && client.Say("x") &&
         client.Hear("HTTP/1.1 408", milliseconds(20)).empty()) {
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, seconds(4));
}

TEST_F(ServerTest, RefusesOversizedHeaders) {
  Start();
  std::string request = "GET /hello HTTP/1.1\r\nHost: localhost\r\n";
  for (int i = 0; i < 20; ++i) request += "X-Pad: " + std::string(4000, 'x') + "\r\n";
  EXPECT_THAT(Ask(request + "\r\n"),
              AllOf(StartsWith("HTTP/1.1 431"), HasSubstr("headers-too-large")));
  EXPECT_THAT(Get("/" + std::string(5000, 'a')), StartsWith("HTTP/1.1 414"));
}

TEST_F(ServerTest, TakesChunkedBodies) {
  Start();
  EXPECT_THAT(Ask("PUT /count HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n"
                  "Transfer-Encoding: chunked\r\n\r\n5\r\nabcde\r\n3\r\nfgh\r\n0\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 200"), ::testing::EndsWith("\r\n\r\n8")));
}

TEST_F(ServerTest, RefusesABodyThatIsTooLongBeforeReadingIt) {
  Start();
  const std::string head = "PUT /small HTTP/1.1\r\nHost: localhost\r\nContent-Type: text/plain\r\n";
  RawClient client(server_->port());
  client.Say(head + "Content-Length: 100000000\r\n\r\n");
  EXPECT_THAT(client.Hear("}"), AllOf(StartsWith("HTTP/1.1 413"), HasSubstr("too-large")));
  // The same when only the chunks tell.
  EXPECT_THAT(Ask(head + "Transfer-Encoding: chunked\r\n\r\nb\r\n01234567890\r\n0\r\n\r\n"),
              StartsWith("HTTP/1.1 413"));
}

TEST_F(ServerTest, GivesARefusalToAClientThatStillSends) {
  Start();
  RawClient client(server_->port());
  const std::string body(4'000'000, 'b');
  EXPECT_TRUE(
      client.Say("PUT /small HTTP/1.1\r\nHost: localhost\r\nContent-Type: text/plain\r\n"
                 "Content-Length: " +
                 std::to_string(body.size()) + "\r\n\r\n" + body));
  EXPECT_THAT(client.Hear(), StartsWith("HTTP/1.1 413"));
}

TEST_F(ServerTest, ReadsNoRequestFromABodyThatAHandlerLeft) {
  Start();
  RawClient client(server_->port());
  const std::string smuggled = "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n";
  client.Say("PUT /ignores HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
             std::to_string(smuggled.size()) + "\r\n\r\n" + smuggled);
  EXPECT_THAT(client.Hear(), AllOf(HasSubstr("no matter"), Not(HasSubstr("hello"))));
}

TEST_F(ServerTest, AnswersExpectContinueBeforeTheBody) {
  Start();
  RawClient client(server_->port());
  client.Say(
      "PUT /count HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\n"
      "Content-Length: 3\r\n\r\n");
  EXPECT_THAT(client.Hear("\r\n\r\n"), StartsWith("HTTP/1.1 100"));
  client.Say("abc");
  EXPECT_THAT(client.Hear("\r\n\r\n3"), StartsWith("HTTP/1.1 200"));
  RawClient refused(server_->port());
  refused.Say(
      "PUT /small HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\n"
      "Content-Type: text/plain\r\nContent-Length: 300000\r\n\r\n");
  EXPECT_THAT(refused.Hear("}"), StartsWith("HTTP/1.1 413"));
}

TEST_F(ServerTest, RefusesABodyThatEndsEarly) {
  Start();
  RawClient client(server_->port());
  client.Say("PUT /count HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\nabc");
  client.FinishSaying();
  EXPECT_THAT(client.Hear(), AllOf(StartsWith("HTTP/1.1 400"), HasSubstr("before it is complete")));
}

TEST_F(ServerTest, IdleAndDribblingConnectionsHoldNoThread) {
  Start();
  std::vector<std::unique_ptr<RawClient>> idle;
  for (int i = 0; i < 100; ++i) {
    idle.push_back(std::make_unique<RawClient>(server_->port()));
    if (i % 2 == 0) idle.back()->Say("GET /hel");
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, seconds(2));
  // And those that dribbled are answered once they are done.
  idle[0]->Say("lo HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(idle[0]->Hear("\r\n\r\nhello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, ClosesAConnectionWhoseHeaderNeverEnds) {
  options_.loop.limits.header_time = milliseconds(150);
  Start();
  RawClient client(server_->port());
  client.Say("GET /hello HTTP/1.1\r\n");
  EXPECT_THAT(client.Hear(), StartsWith("HTTP/1.1 408"));
  EXPECT_TRUE(client.closed());
}

TEST_F(ServerTest, ClosesAnIdleConnection) {
  options_.loop.limits.idle_time = milliseconds(150);
  Start();
  RawClient client(server_->port());
  EXPECT_EQ(client.Hear(), "");
  EXPECT_TRUE(client.closed());
}

TEST_F(ServerTest, GivesUpOnABodyThatStalls) {
  options_.loop.limits.stall_time = milliseconds(150);
  Start();
  RawClient client(server_->port());
  client.Say("PUT /count HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100000\r\n\r\nabc");
  EXPECT_THAT(client.Hear(), StartsWith("HTTP/1.1 408"));
}

TEST_F(ServerTest, MakesRoomForNewConnectionsByClosingTheIdlest) {
  options_.loop.max_connections = 8;
  Start();
  std::vector<std::unique_ptr<RawClient>> idle;
  for (int i = 0; i < 20; ++i) idle.push_back(std::make_unique<RawClient>(server_->port()));
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, StreamsWhatItDoesNotHold) {
  Start();
  EXPECT_THAT(Get("/stream"), AllOf(HasSubstr("Content-Length: 300000\r\n"),
                                    ::testing::EndsWith(std::string(1000, 's'))));
}

TEST_F(ServerTest, CutsAStreamThatFailsInsteadOfPassingItOffAsWhole) {
  Start();
  const std::string answer = Get("/breaks");
  EXPECT_THAT(answer,
              AllOf(HasSubstr("Content-Length: 1000\r\n"), ::testing::EndsWith("a little")));
  EXPECT_THAT(Get("/hello"), StartsWith("HTTP/1.1 200"));
}

TEST_F(ServerTest, StopFinishesWhatRunsAndRefusesWhatComes) {
  Start();
  auto answer = std::async(std::launch::async, [this] { return Get("/slow"); });
  while (slow_running_ == 0) std::this_thread::yield();
  RawClient idle(server_->port());
  EXPECT_TRUE(server_->Stop(seconds(10)));
  EXPECT_THAT(answer.get(), ::testing::EndsWith("slow but done"));
  EXPECT_EQ(idle.Hear(), "");
  EXPECT_FALSE(RawClient(server_->port()).connected());
}

TEST_F(ServerTest, StopWithoutGraceReportsWhatItCut) {
  Start();
  auto answer = std::async(std::launch::async, [this] { return Get("/slow"); });
  while (slow_running_ == 0) std::this_thread::yield();
  EXPECT_FALSE(server_->Stop(milliseconds(1)));
  EXPECT_THAT(answer.get(), Not(HasSubstr("slow but done")));
}

TEST_F(ServerTest, RefusesToServeAnythingButLoopback) {
  for (const char* host : {"0.0.0.0", "::", "192.168.1.1", "example.org", ""}) {
    options_.host = host;
    try {
      Start();
      ADD_FAILURE() << host;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kForbidden) << host;
    }
  }
}

TEST_F(ServerTest, SaysWhenThePortIsTaken) {
  Start();
  options_.port = server_->port();
  Router empty;
  try {
    Server second(std::make_shared<Service>(std::move(empty)), options_);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kConflict);
    EXPECT_THAT(error.what(), HasSubstr("taken"));
  }
}

TEST_F(ServerTest, CountsRequestsByOperationAndStatus) {
  Router router;
  router.Add({"GET", "/hello", "hello", [](const Request&) { return Text("hello"); }, {}, 0});
  auto service = std::make_shared<Service>(std::move(router));
  server_ = std::make_unique<Server>(service, options_);
  Get("/hello");
  Get("/nowhere");
  server_->Stop(seconds(5));
  EXPECT_THAT(service->metrics().ToPrometheus({{"lares_terms", "Terms.", 7}}),
              AllOf(HasSubstr("lares_http_requests_total{operation=\"hello\",status=\"200\"} 1\n"),
                    HasSubstr("lares_http_requests_total{operation=\"none\",status=\"404\"} 1\n"),
                    HasSubstr("_bucket{operation=\"hello\",status=\"200\",le=\"+Inf\"} 1\n"),
                    HasSubstr("# TYPE lares_terms gauge\nlares_terms 7\n")));
}

TEST_F(ServerTest, TheClientUploadsAFormFromFilesAndReadsTheAnswer) {
  Start();
  Client client(server_->url());
  ClientRequest request{"PUT", "/count", {}, {}, {}};
  request.body = EncodeForm({{"a", "text", {}, "", ""}, {"f", "", file_, "f.txt", "text/plain"}});
  const std::uint64_t length = std::get<EncodedForm>(request.body).length;
  std::uint64_t told = 0;
  const ClientResponse response =
      client.Send(request, {{}, [&](std::uint64_t done, std::uint64_t) { told = done; }, {}});
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.body, std::to_string(length));
  EXPECT_EQ(told, length);
}

TEST_F(ServerTest, TheClientStreamsASuccessAndKeepsAProblem) {
  Start();
  Client client(server_->url());
  std::string got;
  const Transfer transfer{[&](std::string_view piece) { got += piece; }, {}, {}};
  EXPECT_EQ(client.Send({"GET", "/stream", {}, {}, {}}, transfer).body, "");
  EXPECT_EQ(got.size(), 300'000u);
  const ClientResponse missing = client.Send({"GET", "/nowhere", {}, {}, {}}, transfer);
  EXPECT_EQ(missing.status, 404);
  EXPECT_THAT(missing.body, HasSubstr("not-found"));
  EXPECT_EQ(client.Send({"HEAD", "/file", {}, {}, {}}).status, 200);
}

TEST_F(ServerTest, TheClientTellsAnAbsentServerFromABrokenAnswer) {
  Start();
  EXPECT_THROW(Client(server_->url()).Send({"GET", "/breaks", {}, {}, {}}), Error);
  const std::string url = server_->url();
  server_.reset();
  EXPECT_THROW(Client(url).Send({"GET", "/hello", {}, {}, {}}), NoServerError);
}

}  // namespace
}  // namespace lares::http
