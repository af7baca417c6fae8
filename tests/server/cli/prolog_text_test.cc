// Answers of goals as text.
#include "server/cli/prolog_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lares::cli {
namespace {

std::string Text(const char* json) { return PrologText(Json::parse(json)); }

TEST(PrologTextTest, IsPrologsNotation) {
  EXPECT_EQ(Text("1"), "1");
  EXPECT_EQ(Text("2.5"), "2.5");
  EXPECT_EQ(Text(R"("a \"b\"")"), R"("a \"b\"")");
  EXPECT_EQ(Text(R"({"type":"uri","value":"https://w3id.org/lares#Cup"})"), "lares:'Cup'");
  EXPECT_EQ(Text(R"({"type":"uri","value":"http://www.w3.org/2002/07/owl#sameAs"})"), "owl:sameAs");
  EXPECT_EQ(Text(R"({"type":"uri","value":"http://x/y"})"), "'http://x/y'");
  EXPECT_EQ(Text(R"({"type":"atom","value":"it's"})"), R"('it\'s')");
  EXPECT_EQ(Text(R"({"type":"literal","value":"grün","xml:lang":"de"})"), "\"grün\"@de");
  EXPECT_EQ(
      Text(R"({"type":"literal","value":"1","datatype":"http://www.w3.org/2001/XMLSchema#int"})"),
      "\"1\"^^xsd:int");
  EXPECT_EQ(Text(R"([1,[],{"type":"cut","why":"size"}])"), "[1, [], <…>]");
  EXPECT_EQ(
      Text(R"({"type":"compound","name":"f","arguments":[1,{"type":"variable","name":"_1"}]})"),
      "f(1, _1)");
}

TEST(PrologTextTest, ControlCharactersStayAwayFromTheTerminal) {
  EXPECT_EQ(Text("\"\\u001b[2J\""), R"("\x1b\[2J")");
}

TEST(PrologTextTest, AnAnswerNamesWhatIsKnown) {
  EXPECT_EQ(AnswerText(Json::parse(R"({"X":1,"Y":{"type":"variable","name":"_1"}})")), "X = 1");
  EXPECT_EQ(AnswerText(Json::object()), "yes");
}

}  // namespace
}  // namespace lares::cli
