#include "server/http/origin_check.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

Request From(const std::string& method, const std::string& host, const std::string& origin = "") {
  Request request;
  request.method = method;
  request.headers.Add("Host", host);
  if (!origin.empty()) request.headers.Add("Origin", origin);
  return request;
}

bool Allowed(const Request& request, const OriginRules& rules = {}) {
  try {
    CheckOrigin(request, rules);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(OriginCheckTest, AllowsTheLoopbackNamesWithAnyPort) {
  for (const char* host : {"localhost", "LOCALHOST:8080", "127.0.0.1", "127.0.0.1:1", "[::1]",
                           "[::1]:8080", "127.1.2.3:80"}) {
    EXPECT_TRUE(Allowed(From("GET", host))) << host;
  }
}

TEST(OriginCheckTest, RefusesEveryOtherName) {
  for (const char* host :
       {"", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "localhost@evil",
        "[::1", "[::2]", "0.0.0.0", "10.0.0.1", "localhost:80:90", "localhost:http", "2130706433",
        "::1", "127.1", "localhost:1234567"}) {
    EXPECT_FALSE(Allowed(From("GET", host))) << host;
  }
}

TEST(OriginCheckTest, AnswersToTheNamesThatItWasGivenToo) {
  const OriginRules rules{{"Lares.example.org", "192.168.1.5"}, false, false};
  for (const char* host :
       {"lares.example.org", "LARES.example.org:8080", "192.168.1.5:1", "localhost"}) {
    EXPECT_TRUE(Allowed(From("GET", host), rules)) << host;
  }
  for (const char* host : {"example.org", "x.lares.example.org", "192.168.1.55", "10.0.0.1"}) {
    EXPECT_FALSE(Allowed(From("GET", host), rules)) << host;
  }
}

TEST(OriginCheckTest, PagesComeOverTheServersOwnScheme) {
  const char* host = "localhost:8080";
  const OriginRules tls{{}, true, false};
  EXPECT_TRUE(Allowed(From("PUT", host, "https://localhost:8080"), tls));
  EXPECT_FALSE(Allowed(From("PUT", host, "http://localhost:8080"), tls));
  const OriginRules proxied{{}, false, true};
  EXPECT_TRUE(Allowed(From("PUT", host, "https://localhost:8080"), proxied));
  EXPECT_TRUE(Allowed(From("PUT", host, "http://localhost:8080"), proxied));
  EXPECT_FALSE(Allowed(From("PUT", host, "https://evil.example"), proxied));
}

TEST(OriginCheckTest, WantsExactlyOneHost) {
  EXPECT_THROW(CheckOrigin(Request{.method = "GET"}), ProblemError);
  Request twice = From("GET", "localhost");
  twice.headers.Add("host", "localhost");
  EXPECT_THROW(CheckOrigin(twice), ProblemError);
}

TEST(OriginCheckTest, OnlyTheServersOwnPagesMayWrite) {
  EXPECT_TRUE(Allowed(From("PUT", "localhost:8080")));
  EXPECT_TRUE(Allowed(From("PUT", "localhost:8080", "http://localhost:8080")));
  EXPECT_TRUE(Allowed(From("PUT", "[::1]:8080", "http://[::1]:8080")));
  for (const char* origin : {"http://evil.example", "http://localhost:9090", "null",
                             "https://localhost:8080", "http://127.0.0.1:8080"}) {
    EXPECT_FALSE(Allowed(From("POST", "localhost:8080", origin))) << origin;
    EXPECT_FALSE(Allowed(From("DELETE", "localhost:8080", origin))) << origin;
    EXPECT_TRUE(Allowed(From("GET", "localhost:8080", origin))) << origin;
  }
}

TEST(OriginCheckTest, WriteWithTwoOriginsOrAnEmptyOneIsRefused) {
  Request twice = From("PUT", "localhost", "http://localhost");
  EXPECT_TRUE(Allowed(twice));
  twice.headers.Add("origin", "http://evil.example");
  EXPECT_FALSE(Allowed(twice));
  Request empty = From("PUT", "localhost");
  empty.headers.Add("Origin", "");
  EXPECT_FALSE(Allowed(empty));
}

TEST(OriginCheckTest, ABrowserThatSaysCrossSiteIsBelieved) {
  Request request = From("PUT", "localhost");
  request.headers.Add("Sec-Fetch-Site", "cross-site");
  EXPECT_FALSE(Allowed(request));
  request.headers.Set("Sec-Fetch-Site", "same-origin");
  EXPECT_TRUE(Allowed(request));
}

}  // namespace
}  // namespace lares::http
