#include "server/http/service.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/http/log.h"

namespace lares::http {
namespace {

using ::testing::HasSubstr;

class ServiceTest : public ::testing::Test {
 protected:
  ServiceTest() : service_(MakeRouter()) { SetLogLevel(LogLevel::kOff); }

  static Router MakeRouter() {
    Router router;
    router.Add({"GET",
                "/text",
                "text",
                [](const Request&) {
                  Response response;
                  response.headers.Set("ETag", "\"t\"");
                  response.headers.Set("Accept-Ranges", "bytes");
                  response.body = std::string("0123456789");
                  return response;
                },
                {},
                0});
    router.Add({"GET",
                "/fails",
                "fails",
                [](const Request&) -> Response { throw Error(Code::kNotFound, "not here"); },
                {},
                0});
    router.Add(
        {"PUT", "/text", "put", [](const Request&) { return Response{}; }, {"text/plain"}, 10});
    return router;
  }

  static Request Ask(const std::string& method, const std::string& path) {
    Request request;
    request.method = method;
    request.path = path;
    request.headers.Set("Host", "localhost");
    return request;
  }
  static Request Send(const std::string& type, std::uint64_t length) {
    Request request = Ask("PUT", "/text");
    if (!type.empty()) request.headers.Set("Content-Type", type);
    request.has_body = true;
    request.content_length = length;
    return request;
  }
  static std::string CodeOf(const Response& response) {
    return nlohmann::json::parse(std::get<std::string>(response.body))["code"];
  }

  Service service_;
};

TEST_F(ServiceTest, EveryAnswerCarriesARequestId) {
  Request request = Ask("GET", "/text");
  request.headers.Set("X-Request-Id", "abc-1");
  EXPECT_EQ(service_.Answer(request).headers.Get("X-Request-Id"), "abc-1");
  EXPECT_EQ(service_.Answer(Ask("GET", "/nowhere")).headers.Get("X-Request-Id").size(), 16u);
}

TEST_F(ServiceTest, AnIdThatCouldForgeALogLineIsReplaced) {
  const std::vector<std::string> forged{"a b", "a\nb", std::string(129, 'a')};
  for (const std::string& sent : forged) {
    EXPECT_NE(RequestId(sent), sent);
  }
  EXPECT_NE(RequestId(""), RequestId(""));
}

TEST_F(ServiceTest, UnknownPathsAndMethodsAreProblems) {
  EXPECT_EQ(service_.Answer(Ask("GET", "/nowhere")).status, 404);
  const Response wrong = service_.Answer(Ask("DELETE", "/text"));
  EXPECT_EQ(wrong.status, 405);
  EXPECT_EQ(wrong.headers.Get("Allow"), "GET, HEAD, PUT");
  EXPECT_EQ(CodeOf(wrong), "method-not-allowed");
}

TEST_F(ServiceTest, AFaultOfAHandlerBecomesAProblem) {
  const Response response = service_.Answer(Ask("GET", "/fails"));
  EXPECT_EQ(response.status, 404);
  EXPECT_EQ(CodeOf(response), "not-found");
}

TEST_F(ServiceTest, BodiesNeedATypeThatTheRouteTakes) {
  EXPECT_EQ(service_.Answer(Send("text/plain; charset=utf-8", 3)).status, 200);
  EXPECT_EQ(service_.Answer(Send("", 3)).status, 415);
  EXPECT_EQ(service_.Answer(Send("image/png", 3)).status, 415);
  EXPECT_EQ(service_.Answer(Send("text/plain", 11)).status, 413);
  Request packed = Send("text/plain", 3);
  packed.headers.Set("Content-Encoding", "gzip");
  EXPECT_EQ(service_.Answer(packed).status, 415);
  Request unwanted = Ask("GET", "/text");
  unwanted.has_body = true;
  unwanted.content_length = 3;
  EXPECT_EQ(service_.Answer(unwanted).status, 400);
}

TEST_F(ServiceTest, ConditionsComeBeforeRanges) {
  Request request = Ask("GET", "/text");
  request.headers.Set("Range", "bytes=0-1");
  request.headers.Set("If-None-Match", "\"t\"");
  EXPECT_EQ(service_.Answer(request).status, 304);
}

TEST_F(ServiceTest, ARangeIsGivenOnlyOfTheVersionThatIfRangeNames) {
  Request request = Ask("GET", "/text");
  request.headers.Set("Range", "bytes=3-4");
  request.headers.Set("If-Range", "\"t\"");
  const Response part = service_.Answer(request);
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(std::get<std::string>(part.body), "34");
  request.headers.Set("If-Range", "\"older\"");
  EXPECT_EQ(service_.Answer(request).status, 200);
}

TEST_F(ServiceTest, NoAnswerInvitesOtherOrigins) {
  Request request = Ask("GET", "/text");
  request.headers.Set("Origin", "http://evil.example");
  const Response response = service_.Answer(request);
  for (const auto& [name, value] : response.headers.all()) {
    EXPECT_THAT(name, ::testing::Not(HasSubstr("Access-Control")));
  }
}

}  // namespace
}  // namespace lares::http
