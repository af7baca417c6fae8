#include "server/http/problem.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace lares::http {
namespace {

nlohmann::json Document(const Response& response) {
  return nlohmann::json::parse(std::get<std::string>(response.body));
}

TEST(ProblemTest, EveryCodeHasItsStatus) {
  for (int code = 0; code <= static_cast<int>(Code::kInternal); ++code) {
    const ProblemKind& kind = FindProblemKind(ToString(static_cast<Code>(code)));
    EXPECT_GE(kind.status, 400) << kind.code;
    EXPECT_FALSE(kind.title.empty());
  }
  EXPECT_EQ(FindProblemKind("invalid").status, 422);
  EXPECT_EQ(FindProblemKind("precondition-failed").status, 412);
  EXPECT_EQ(FindProblemKind("unavailable").status, 503);
}

TEST(ProblemTest, NoCodeIsThereTwice) {
  std::set<std::string_view> codes;
  for (const ProblemKind& kind : ProblemKinds()) {
    EXPECT_TRUE(codes.insert(kind.code).second) << kind.code;
  }
}

TEST(ProblemTest, SaysEverythingThatTheErrorKnows) {
  Error error(Code::kInvalid, "malformed comment", Place{"recipe.owl", 715, 6});
  error.WithHint("use --recover").WithCandidates({"a", "b"});
  const Response response = ToProblem(error, "id-1");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(response.headers.Get("Content-Type"), "application/problem+json");
  const auto document = Document(response);
  EXPECT_EQ(document["type"], "https://w3id.org/lares/problems/invalid");
  EXPECT_EQ(document["status"], 422);
  EXPECT_EQ(document["detail"], "malformed comment");
  EXPECT_EQ(document["instance"], "id-1");
  EXPECT_EQ(document["place"]["source"], "recipe.owl");
  EXPECT_EQ(document["place"]["line"], 715);
  EXPECT_EQ(document["place"]["column"], 6);
  EXPECT_EQ(document["hint"], "use --recover");
  EXPECT_EQ(document["candidates"], (std::vector<std::string>{"a", "b"}));
}

TEST(ProblemTest, LeavesOutWhatIsNotKnown) {
  const auto document = Document(ToProblem(Error(Code::kNotFound, "no"), "x"));
  for (const char* member : {"place", "hint", "candidates"}) {
    EXPECT_FALSE(document.contains(member)) << member;
  }
  const auto placed = Document(ToProblem(Error(Code::kInvalid, "no", Place{"f", 0, 0}), "x"));
  EXPECT_FALSE(placed["place"].contains("line"));
}

TEST(ProblemTest, FurtherMembersJoinButReplaceNothing) {
  const ProblemError error =
      ProblemError("not-feasible", "no").WithMembers(R"({"match":{"a":1},"status":200})");
  const auto document = Document(ToProblem(error, "x"));
  EXPECT_EQ(document["match"]["a"], 1);
  EXPECT_EQ(document["status"], 422);
  EXPECT_EQ(document["code"], "not-feasible");
}

TEST(ProblemTest, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_NO_THROW(Document(ToProblem(Error(Code::kInvalid, "bad \xff byte"), "x")));
}

TEST(ProblemTest, AnUnknownKindIsOurOwnFault) {
  EXPECT_THROW(ProblemError("no-such-kind", "x"), Error);
}

}  // namespace
}  // namespace lares::http
