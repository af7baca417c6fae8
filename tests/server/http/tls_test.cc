// TLS, with a certificate that openssl makes for the test.
#include "server/http/tls.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "server/http/client.h"
#include "server/http/event_channel.h"
#include "server/http/log.h"
#include "server/http/server.h"
#include "tests/server/http/raw_client.h"

namespace lares::http {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;

class TlsTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::path(::testing::TempDir()) / ("lares_tls_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    MakeCertificate("host", "subjectAltName=IP:127.0.0.1,DNS:localhost");
    MakeCertificate("other", "subjectAltName=DNS:lares.example.org");
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static void MakeCertificate(const std::string& name, const std::string& names) {
    const std::string path = (folder_ / name).string();
    const std::string command =
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 "
        "-subj /CN=lares-test -addext " +
        names + " -keyout " + path + ".key -out " + path + ".pem 2>/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  TlsTest() {
    SetLogLevel(LogLevel::kOff);
    options_.port = 0;
    options_.loop.threads = 4;
    options_.tls = TlsOptions{folder_ / "host.pem", folder_ / "host.key"};
  }

  void Start() {
    Router router;
    const auto add = [&router](const char* method, const char* path, Handler handler,
                               std::vector<std::string> consumes = {}) {
      router.Add({method, path, path + 1, std::move(handler), std::move(consumes), 1u << 30});
    };
    add("GET", "/hello", [](const Request&) {
      Response response;
      response.body = "hello";
      return response;
    });
    add("GET", "/large", [](const Request&) {
      Response response;
      response.body = StreamBody{3'000'000, [](const Sink& sink) {
                                   for (int i = 0; i < 3000; ++i) sink(std::string(1000, 's'));
                                 }};
      return response;
    });
    add("PUT", "/count",
        [](const Request& request) {
          std::uint64_t bytes = 0;
          request.read_body([&](std::string_view piece) { bytes += piece.size(); });
          Response response;
          response.body = std::to_string(bytes);
          return response;
        },
        {"*/*"});
    add("GET", "/events", [](const Request&) {
      Response response;
      response.headers.Set("Content-Type", "text/event-stream");
      response.body = EventsBody{[](const std::shared_ptr<EventChannel>& channel) {
        channel->Send({"first", "1", "one"});
        channel->End();
      }};
      return response;
    });
    server_ = std::make_unique<Server>(std::make_shared<Service>(std::move(router)), options_);
  }

  Client Trusting(const std::string& certificate = "host.pem") const {
    ClientOptions options;
    options.ca_file = folder_ / certificate;
    return Client(server_->url(), options);
  }

  // What openssl's own client makes of the server with these arguments.
  int OpensslClient(const std::string& arguments) const {
    const std::string command =
        "timeout 10 openssl s_client -connect 127.0.0.1:" + std::to_string(server_->port()) + " " +
        arguments + " </dev/null >/dev/null 2>&1";
    return std::system(command.c_str());
  }

  static inline fs::path folder_;
  ServerOptions options_;
  std::unique_ptr<Server> server_;
};

TEST_F(TlsTest, AnswersWhoTrustsItsCertificate) {
  Start();
  EXPECT_THAT(server_->url(), HasSubstr("https://"));
  Client client = Trusting();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(client.Send({"GET", "/hello", {}, {}, {}}).body, "hello");
}

TEST_F(TlsTest, LargeBodiesGoBothWaysWhole) {
  Start();
  Client client = Trusting();
  EXPECT_EQ(client.Send({"GET", "/large", {}, {}, {}}).body, std::string(3'000'000, 's'));
  ClientRequest put{"PUT", "/count", {}, {}, std::string(5'000'000, 'x')};
  put.headers.Set("Content-Type", "text/plain");
  EXPECT_EQ(client.Send(put).body, "5000000");
  put.body = std::string(30'000, 'x');
  EXPECT_EQ(client.Send(put).body, "30000");
}

TEST_F(TlsTest, EventStreamsAreWholeToo) {
  Start();
  EXPECT_THAT(Trusting().Send({"GET", "/events", {}, {}, {}}).body, HasSubstr("data: one"));
}

TEST_F(TlsTest, ClientsRefuseACertificateThatNobodyVouchesForOrOfAnotherName) {
  Start();
  const auto code = [](Client client) {
    try {
      client.Send({"GET", "/hello", {}, {}, {}});
    } catch (const Error& error) {
      return error.code();
    }
    return Code::kInternal;
  };
  EXPECT_EQ(code(Client(server_->url())), Code::kForbidden);
  EXPECT_EQ(code(Trusting("other.pem")), Code::kForbidden);
  server_.reset();
  options_.tls = TlsOptions{folder_ / "other.pem", folder_ / "other.key"};
  Start();
  EXPECT_EQ(code(Trusting("other.pem")), Code::kForbidden);  // it is not 127.0.0.1's
}

TEST_F(TlsTest, OldVersionsOfTheProtocolAreRefused) {
  Start();
  EXPECT_EQ(OpensslClient("-tls1_3"), 0);
  EXPECT_EQ(OpensslClient("-tls1_2"), 0);
  EXPECT_NE(OpensslClient("-tls1_1 -cipher 'ALL:@SECLEVEL=0'"), 0);
  EXPECT_NE(OpensslClient("-tls1 -cipher 'ALL:@SECLEVEL=0'"), 0);
  EXPECT_NE(OpensslClient("-tls1_2 -cipher AES128-SHA"), 0);  // no forward secrecy
}

TEST_F(TlsTest, PlainTextAndGarbageAreDroppedAndTheServerGoesOn) {
  Start();
  for (const std::string& bytes :
       {std::string("GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n"),
        std::string("\x16\x03\x01\xff\xff", 5) + std::string(40'000, 'z'),
        std::string(1000, '\0')}) {
    RawClient client(server_->port());
    client.Say(bytes);
    EXPECT_THAT(client.Hear("", seconds(5)), ::testing::Not(HasSubstr("hello")));
    EXPECT_TRUE(client.closed());
  }
  EXPECT_EQ(Trusting().Send({"GET", "/hello", {}, {}, {}}).body, "hello");
}

TEST_F(TlsTest, AHandshakeThatDoesNotComeHoldsNoThreadAndEndsInTime) {
  options_.loop.limits.header_time = seconds(2);
  Start();
  std::vector<std::unique_ptr<RawClient>> silent;
  for (int i = 0; i < 20; ++i) {
    silent.push_back(std::make_unique<RawClient>(server_->port()));
    if (i % 2 == 0) silent.back()->Say("\x16");
  }
  EXPECT_EQ(Trusting().Send({"GET", "/hello", {}, {}, {}}).body, "hello");
  for (const auto& client : silent) {
    client->Hear("", seconds(8));
    EXPECT_TRUE(client->closed());
  }
}

TEST_F(TlsTest, FilesThatAreNoCertificateOrKeyAreRefusedByName) {
  std::ofstream(folder_ / "text.pem") << "no certificate";
  const auto message = [](const fs::path& certificate, const fs::path& key) -> std::string {
    try {
      TlsContext({certificate, key});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message(folder_ / "absent.pem", folder_ / "host.key"), HasSubstr("absent.pem"));
  EXPECT_THAT(message(folder_ / "text.pem", folder_ / "host.key"), HasSubstr("text.pem"));
  EXPECT_THAT(message(folder_ / "host.pem", folder_ / "text.pem"), HasSubstr("text.pem"));
  EXPECT_THAT(message(folder_ / "host.pem", folder_ / "other.key"), HasSubstr("other.key"));
}

}  // namespace
}  // namespace lares::http
