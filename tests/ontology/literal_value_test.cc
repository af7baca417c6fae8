#include "ontology/rdf/literal_value.h"

#include <gtest/gtest.h>

#include "ontology/rdf/vocabulary.h"
#include "ontology/triples/dictionary.h"

namespace lares::rdf {
namespace {

std::string Iri(std::string_view type) {
  if (type == "PlainLiteral" || type == "XMLLiteral") return std::string(kRdf).append(type);
  return std::string(type == "Literal" ? kRdfs : kXsd).append(type);
}

std::optional<DataValue> Value(std::string_view text, std::string_view type) {
  return ValueOf(Term::Literal(text, Iri(type)).view());
}

void ExpectSame(std::string_view a, std::string_view a_type, std::string_view b,
                std::string_view b_type) {
  const auto first = Value(a, a_type), second = Value(b, b_type);
  ASSERT_TRUE(first && second) << a << " " << b;
  EXPECT_EQ(*first, *second) << a << " " << b;
}

TEST(LiteralValueTest, IntegersOfAllTypesAndDecimalsShareOneValueSpace) {
  ExpectSame("1", "int", "+01", "integer");
  ExpectSame("1", "unsignedByte", "1.0", "decimal");
  ExpectSame("-0", "integer", "0", "nonPositiveInteger");
  ExpectSame("-.50", "decimal", "-0.5", "decimal");
  EXPECT_NE(*Value("1", "integer"), *Value("1.5", "decimal"));
  EXPECT_NE(*Value("1", "integer"), *Value("1", "double"));
  EXPECT_NE(*Value("1", "float"), *Value("1", "double"));
}

TEST(LiteralValueTest, BoundsOfIntegerTypesAreSharp) {
  EXPECT_TRUE(Value("127", "byte") && Value("-128", "byte"));
  EXPECT_FALSE(Value("128", "byte") || Value("-129", "byte"));
  EXPECT_TRUE(Value("18446744073709551615", "unsignedLong"));
  EXPECT_FALSE(Value("18446744073709551616", "unsignedLong"));
  EXPECT_TRUE(Value("123456789012345678901234567890", "integer"));
  EXPECT_FALSE(Value("0", "positiveInteger") || Value("-1", "nonNegativeInteger"));
}

TEST(LiteralValueTest, WhatIsNotOfTheLexicalSpaceHasNoValue) {
  for (const auto& [text, type] :
       std::vector<std::pair<const char*, const char*>>{{"", "integer"},
                                                        {"+", "integer"},
                                                        {"1.0", "integer"},
                                                        {" 1", "integer"},
                                                        {".", "decimal"},
                                                        {"1e3", "decimal"},
                                                        {"1e", "double"},
                                                        {"e1", "double"},
                                                        {"infinity", "double"},
                                                        {"1e400", "double"},
                                                        {"1e-400", "double"},
                                                        {"1e40", "float"},
                                                        {"TRUE", "boolean"},
                                                        {"2009-04-21", "dateTime"},
                                                        {"2009-02-29T00:00:00", "dateTime"},
                                                        {"2009-04-21T24:00:01", "dateTime"},
                                                        {"2009-04-21T12:30:15", "dateTimeStamp"},
                                                        {"2009-04-21T12:30:15+15:00", "dateTime"},
                                                        {"A", "hexBinary"},
                                                        {"QQ", "base64Binary"},
                                                        {"QR==", "base64Binary"},
                                                        {":abc", "anyURI"},
                                                        {"a b", "anyURI"},
                                                        {"en-", "language"},
                                                        {" abc", "token"},
                                                        {"a  b", "token"},
                                                        {"a\tb", "normalizedString"},
                                                        {".tag", "Name"},
                                                        {"ex:tag", "NCName"},
                                                        {"a b", "NMTOKEN"},
                                                        {"abc", "PlainLiteral"},
                                                        {"abc@12", "PlainLiteral"},
                                                        {"<a>", "XMLLiteral"},
                                                        {"</x><x>", "XMLLiteral"},
                                                        {"x", "Literal"},
                                                        {"1", "duration"}}) {
    EXPECT_FALSE(Value(text, type)) << text << " as " << type;
  }
}

TEST(LiteralValueTest, TimesAreComparedByIdentity) {
  ExpectSame("2009-04-21T12:30:15.50Z", "dateTime", "2009-04-21T12:30:15.5+00:00", "dateTimeStamp");
  ExpectSame("2008-12-31T24:00:00", "dateTime", "2009-01-01T00:00:00", "dateTime");
  EXPECT_NE(*Value("2009-04-21T12:00:00Z", "dateTime"),
            *Value("2009-04-21T13:00:00+01:00", "dateTime"));
  EXPECT_TRUE(Value("2008-02-29T00:00:00", "dateTime") &&
              Value("-0044-03-15T00:00:00", "dateTime"));
}

TEST(LiteralValueTest, TextOfDerivedTypesIsTheText) {
  ExpectSame("abc", "token", "abc", "string");
  ExpectSame("abc@", "PlainLiteral", "abc", "string");
  EXPECT_EQ(*Value("abc@EN", "PlainLiteral"), *ValueOf(Term::Literal("abc", {}, "en").view()));
  EXPECT_NE(*Value("abc", "string"), *ValueOf(Term::Literal("abc", {}, "en").view()));
  EXPECT_NE(*Value("http://a", "anyURI"), *Value("http://a", "string"));
  ExpectSame("af", "hexBinary", "AF", "hexBinary");
  ExpectSame("1", "boolean", "true", "boolean");
  ExpectSame("10", "double", "1.0E1", "double");
}

TEST(LiteralValueTest, ADatatypeHoldsTheValuesOfItsSpace) {
  EXPECT_TRUE(IsInDatatype(*Value("5", "int"), Iri("unsignedByte")));
  EXPECT_TRUE(IsInDatatype(*Value("5.0", "decimal"), Iri("positiveInteger")));
  EXPECT_FALSE(IsInDatatype(*Value("5.5", "decimal"), Iri("integer")));
  EXPECT_FALSE(IsInDatatype(*Value("300", "int"), Iri("unsignedByte")));
  EXPECT_TRUE(IsInDatatype(*Value("en", "string"), Iri("language")));
  EXPECT_FALSE(IsInDatatype(*ValueOf(Term::Literal("en", {}, "de").view()), Iri("string")));
  EXPECT_TRUE(IsInDatatype(*ValueOf(Term::Literal("en", {}, "de").view()), Iri("PlainLiteral")));
  EXPECT_FALSE(IsInDatatype(*Value("2009-04-21T12:00:00", "dateTime"), Iri("dateTimeStamp")));
  EXPECT_TRUE(IsInDatatype(*Value("1", "boolean"), Iri("Literal")));
  EXPECT_FALSE(IsInDatatype(*Value("1", "boolean"), "http://example.org/own"));
}

TEST(DictionaryValueTest, LiteralsOfOneValueKnowEachOther) {
  Dictionary dictionary;
  const auto intern = [&](std::string_view text, std::string_view type) {
    return dictionary.Intern(Term::Literal(text, type.empty() ? "" : Iri(type)).view());
  };
  const TermId one = intern("1", "int"), same = intern("1.0", "decimal");
  const TermId other = intern("2", "int"), bad = intern("x", "int");
  EXPECT_EQ(dictionary.SameValue(same), one);
  EXPECT_EQ(dictionary.SameValue(one), one);
  EXPECT_EQ(dictionary.ValueTwins(one), (std::vector<TermId>{one, same}));
  EXPECT_EQ(dictionary.ValueTwins(same), (std::vector<TermId>{one, same}));
  EXPECT_TRUE(dictionary.ValueTwins(other).empty() && dictionary.ValueTwins(bad).empty());

  const TermId plain = intern("abc", ""), token = intern("abc", "token");
  EXPECT_EQ(dictionary.SameValue(token), plain);
  const TermId name = intern("def", "NCName"), later = intern("def", "");
  EXPECT_EQ(dictionary.SameValue(later), name);
}

}  // namespace
}  // namespace lares::rdf
