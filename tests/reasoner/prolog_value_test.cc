// Values through Prolog and back.
#include "reasoner/prolog/value.h"

#include <limits>

#include "base/error.h"
#include "tests/reasoner/prolog_fixture.h"

namespace lares::prolog::testing {
namespace {

using PrologValue = PrologTest;
using ::testing::HasSubstr;

TEST_F(PrologValue, EveryKindComesBackAsItWas) {
  const std::vector<Value> values = {
      I(0),
      I(-7),
      I(std::numeric_limits<std::int64_t>::max()),
      I(std::numeric_limits<std::int64_t>::min()),
      {0.1},
      {-1e300},
      A("atom"),
      A(""),
      A("[]"),
      A("with 'quotes' and \n"),
      A("grüße 字 😀"),
      S("text"),
      S(""),
      S("grüße 字 😀"),
      S(std::string("a\0b", 3)),
      {List{}},
      {List{I(1), A("b"), {List{}}}},
      C("f", {I(1), C("g", {A("x")})}),
      C("zero", {}),
      C(",", {A("a"), A("b")}),
      {Dict{}},
      {Dict{{"a", I(1)}, {"b", {List{S("x")}}}, {"c", {Dict{{"d", A("e")}}}}}}};
  for (const Value& value : values) {
    EXPECT_EQ(Once("echo", {value}), value) << value.data.index();
  }
}

TEST_F(PrologValue, LongTextSurvives) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += i % 3 == 0 ? "ö" : "x";
  EXPECT_EQ(Once("echo", {S(text)}), S(text));
  EXPECT_EQ(Once("echo", {A(text)}), A(text));
}

TEST_F(PrologValue, LongListsAreNoNesting) {
  Value list{List(100'000, C("f", {I(1)}))};
  EXPECT_EQ(Once("echo", {list}), list);
}

TEST_F(PrologValue, TextThatIsNoUtf8IsRefused) {
  EXPECT_EQ(ErrorOf("echo", {A("\xff")}).code(), Code::kInvalid);
  EXPECT_EQ(ErrorOf("echo", {S("\xc3")}).code(), Code::kInvalid);
  EXPECT_EQ(ErrorOf("echo", {{Dict{{"\xff", I(1)}}}}).code(), Code::kInvalid);
}

TEST_F(PrologValue, WhatNoValueCanHoldIsAnErrorThatSaysSo) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"variable", "unbound"},
      {"nested_variable", "unbound"},
      {"big", "64 bits"},
      {"rational", "rational"},
      {"cyclic", "cyclic"},
      {"cyclic_list", "cyclic"},
      {"partial_list", "without an end"},
      {"improper_list", "without an end"},
      {"stream", "opaque"},
      {"numbered_dict", "key"}};
  for (const auto& [name, text] : cases) {
    const Error error = ErrorOf("odd", {A(name)});
    EXPECT_EQ(error.code(), Code::kInternal) << name;
    EXPECT_THAT(error.what(), HasSubstr(text)) << name;
  }
}

TEST_F(PrologValue, OddButHonestTermsAreValues) {
  EXPECT_EQ(Once("odd", {A("edge")}), I(std::numeric_limits<std::int64_t>::max()));
  EXPECT_EQ(Once("odd", {A("zero_arity")}), C("f", {}));
  EXPECT_EQ(Once("odd", {A("empty_atom")}), A(""));
  EXPECT_EQ(Once("odd", {A("not_quite_empty_list")}), A("[]"));
  EXPECT_EQ(Once("odd", {A("nul")}), A(std::string("a\0b", 3)));
}

TEST_F(PrologValue, TermsThatWouldExplodeAreTooLarge) {
  EXPECT_EQ(ErrorOf("odd", {A("wide")}).code(), Code::kTooLarge);
}

TEST_F(PrologValue, NestingHasALimitInBothDirections) {
  EXPECT_EQ(ErrorOf("deep", {I(100'000)}).code(), Code::kTooLarge);
  EXPECT_TRUE(Once("deep", {I(1000)}));
  Value nested = A("end");
  for (int i = 0; i < 5000; ++i) {
    List arguments;
    arguments.push_back(std::move(nested));
    nested = C("f", std::move(arguments));
  }
  EXPECT_EQ(ErrorOf("echo", {nested}).code(), Code::kTooLarge);
}

TEST(Value, TypedAccessNamesWhatWasFoundInstead) {
  EXPECT_EQ(I(3).integer(), 3);
  EXPECT_EQ(I(3).number(), 3.0);
  EXPECT_EQ(A("a").text() + S("b").text(), "ab");
  const Value dict{Dict{{"a", I(1)}}};
  EXPECT_EQ(dict.at("a").integer(), 1);
  EXPECT_EQ(dict.find("b"), nullptr);
  EXPECT_THROW(dict.at("b"), Error);
  try {
    A("a").list();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("an atom where a list"));
  }
}

}  // namespace
}  // namespace lares::prolog::testing
