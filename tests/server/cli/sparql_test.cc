#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "server/cli/query.h"
#include "tests/server/cli/cli_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class SparqlCommandTest : public CliTest {
 protected:
  SparqlCommandTest() {
    Answers().view = [](const server::ViewRequest&) {
      return ViewOfTurtle(R"(@prefix : <https://w3id.org/lares#> .
:cup1 a :Cup ; :weight 3 ; :label "a\nb"@en . <urn:x:1> a <http://other.example/Thing> .)");
    };
  }
};

TEST_F(SparqlCommandTest, PrintsATableWithShortNames) {
  const Outcome asked =
      Lares({"sparql", "-q", "SELECT ?c ?w ?l { ?c lares:weight ?w ; lares:label ?l }"});
  EXPECT_EQ(asked.code, 0) << asked.err;
  EXPECT_EQ(asked.out,
            "?c          ?w  ?l\n"
            "lares:cup1  3   \"a\\nb\"@en\n"
            "1 row\n");
  const Outcome declared =
      Lares({"sparql", "-q",
             "PREFIX o: <http://other.example/> SELECT * { ?x a ?t FILTER(?t = o:Thing)}"});
  EXPECT_THAT(declared.out, HasSubstr("<urn:x:1>"));
  EXPECT_THAT(declared.out, HasSubstr("o:Thing"));
}

TEST_F(SparqlCommandTest, PrintsEveryFormInItsFormats) {
  EXPECT_EQ(Lares({"sparql", "-q", "ASK { ?c a lares:Cup }"}).out, "yes\n");
  const std::string select = "SELECT ?c { ?c a lares:Cup }";
  EXPECT_EQ(Lares({"sparql", "-q", select, "--format", "csv"}).out,
            "c\r\nhttps://w3id.org/lares#cup1\r\n");
  EXPECT_TRUE(nlohmann::json::parse(Lares({"--json", "sparql", "-q", select}).out).is_object());
  EXPECT_THAT(Lares({"sparql", "-q", "DESCRIBE lares:cup1"}).out, HasSubstr("lares#"));
  EXPECT_THAT(Lares({"sparql", "-q", "DESCRIBE lares:cup1", "--format", "ntriples"}).out,
              HasSubstr("<https://w3id.org/lares#cup1> "));
  EXPECT_FALSE(Lares({"sparql", "-q", select, "--explain", "plan"}).out.empty());
  const std::string file = Write("query.rq", select).string();
  EXPECT_THAT(Lares({"sparql", file}).out, HasSubstr("lares:cup1"));
}

TEST_F(SparqlCommandTest, SaysWhatIsWrongByItsExitCode) {
  EXPECT_EQ(Lares({"sparql"}).code, 2);
  EXPECT_EQ(Lares({"sparql", "-q", "ASK {}", "file.rq"}).code, 2);
  const Outcome malformed = Lares({"sparql", "-q", "SELECT ?c {\n ?c a"});
  EXPECT_EQ(malformed.code, 3);
  EXPECT_THAT(malformed.err, HasSubstr("2:"));
  EXPECT_EQ(Lares({"sparql", "-q", "DESCRIBE lares:cup1", "--format", "csv"}).code, 3);
  EXPECT_EQ(Lares({"sparql", "-q", "SELECT * {?a ?b ?c}", "--max-rows", "1"}).code, 3);
  EXPECT_EQ(Lares({"sparql", "no-such-file.rq"}).code, 1);
  std::string cross = "SELECT (COUNT(*) AS ?n) {";
  for (int i = 0; i < 16; ++i) {
    const std::string n = std::to_string(i);
    cross += " ?a" + n + " ?b" + n + " ?c" + n + " .";
  }
  EXPECT_EQ(Lares({"sparql", "-q", cross + "}", "--timeout", "0.1"}).code, 8);
}

TEST(TermPrinter, KeepsATermOnItsLine) {
  const cli::TermPrinter printer;
  const auto print = [&](const char* json) {
    return printer.Print(nlohmann::ordered_json::parse(json));
  };
  EXPECT_EQ(print(R"({"type":"literal","value":"a\nb\"c\u001b"})"), R"("a\nb\"c\u001B")");
  EXPECT_EQ(print(R"({"type":"bnode","value":"b1"})"), "_:b1");
  EXPECT_EQ(print(R"({"type":"uri","value":"https://w3id.org/lares#a b"})"),
            "<https://w3id.org/lares#a b>");
  EXPECT_EQ(print(R"({"type":"literal","value":"5","datatype":
            "http://www.w3.org/2001/XMLSchema#integer"})"),
            "5");
  EXPECT_EQ(print(R"({"type":"literal","value":"x","datatype":"urn:t"})"), "\"x\"^^<urn:t>");
}

}  // namespace
}  // namespace lares::testing
