// Turtle, TriG, N-Triples and N-Quads: what is read, and what is refused where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using ::testing::ElementsAre;
using testing::FaultOf;
using testing::Lines;
using testing::MessageOf;
using testing::Named;
using ::testing::Pair;

constexpr const char* kPrefix = "@prefix ex: <http://e/> .\n";

Document Turtle(const std::string& text) { return ReadRdf(text, Format::kTurtle, Named("x")); }

TEST(TurtleReader, ReadsTermsOfEveryKind) {
  EXPECT_EQ(Lines(Turtle(std::string(kPrefix) +
                         "ex:a a ex:B ; ex:p \"x\", \"y\"@en-GB, 5, 1.5, true, _:n .")),
            "<http://e/a> <http://e/p> \"1.5\"^^<http://www.w3.org/2001/XMLSchema#decimal>  .\n"
            "<http://e/a> <http://e/p> \"5\"^^<http://www.w3.org/2001/XMLSchema#integer>  .\n"
            "<http://e/a> <http://e/p> \"true\"^^<http://www.w3.org/2001/XMLSchema#boolean>  .\n"
            "<http://e/a> <http://e/p> \"x\"  .\n"
            "<http://e/a> <http://e/p> \"y\"@en-gb  .\n"
            "<http://e/a> <http://e/p> _:n  .\n"
            "<http://e/a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://e/B>  .\n");
}

TEST(TurtleReader, TermsAreStoredOnce) {
  const Document document = Turtle(std::string(kPrefix) + "ex:a ex:a ex:a, \"a\", \"a\"@en .");
  EXPECT_EQ(document.statements.size(), 3u);
  EXPECT_EQ(document.terms.size(), 3u);
}

TEST(TurtleReader, StringDatatypeIsTheSameAsNone) {
  const Document document =
      Turtle("<http://e/a> <http://e/p> \"x\", \"x\"^^<http://www.w3.org/2001/XMLSchema#string> .");
  EXPECT_EQ(document.terms.size(), 3u);
  EXPECT_EQ(document.terms[2], Term::Literal("x"));
}

TEST(TurtleReader, PrefixesImportsAndBaseAreRecorded) {
  const Document document = Turtle(
      "@base <http://e/dir/doc> .\n@prefix : <#> .\n@prefix owl: "
      "<http://www.w3.org/2002/07/owl#> .\n<> owl:imports <other>, <../third> .");
  EXPECT_EQ(document.base_iri, "http://e/dir/doc");
  EXPECT_THAT(document.prefixes, ElementsAre(Pair("", "http://e/dir/doc#"),
                                             Pair("owl", "http://www.w3.org/2002/07/owl#")));
  EXPECT_THAT(document.imports, ElementsAre("http://e/dir/other", "http://e/third"));
}

TEST(TurtleReader, GivenBaseResolvesRelativeIris) {
  ReadOptions options = Named("x");
  options.base_iri = "http://e/a/b?q";
  const Document document = ReadRdf("<c> <./d/../e> <#f> .", Format::kTurtle, options);
  EXPECT_EQ(Lines(document), "<http://e/a/c> <http://e/a/e> <http://e/a/b?q#f>  .\n");
  EXPECT_EQ(document.base_iri, "http://e/a/b?q");
}

TEST(TurtleReader, BlankLabelsThatSerdWouldConfuseStayApart) {
  const Document document =
      Turtle(std::string(kPrefix) + "_:b1 ex:p _:B1 . [] ex:q _:b1 . # _:b1\nex:s ex:p '_:b1' .");
  const Document expected = ReadRdf(
      "_:x <http://e/p> _:y .\n_:z <http://e/q> _:x .\n<http://e/s> <http://e/p> \"_:b1\" .",
      Format::kNTriples, Named("y"));
  EXPECT_TRUE(testing::AreIsomorphic(document, expected)) << Lines(document);
}

TEST(TurtleReader, GraphsOfTriGAreKept) {
  EXPECT_EQ(Lines(ReadRdf("<http://e/a> <http://e/p> 'x' . <http://e/g> { <http://e/a> <http://e/p>"
                          " 'x' }",
                          Format::kTriG, Named("x"))),
            "<http://e/a> <http://e/p> \"x\"  .\n<http://e/a> <http://e/p> \"x\" <http://e/g> .\n");
}

TEST(TurtleReader, ByteOrderMarkAndCarriageReturnsAreWhiteSpace) {
  EXPECT_EQ(Turtle("\xEF\xBB\xBF<http://e/a> a <http://e/b> .\r\n").statements.size(), 1u);
  EXPECT_EQ(ReadRdf("\xEF\xBB\xBF<http://e/a> <http://e/b> <http://e/b> .\r\n\r\n# x\r\n",
                    Format::kNTriples, Named("x"))
                .statements.size(),
            1u);
}

TEST(TurtleReader, EmptyDocumentsSayNothing) {
  for (const Format format : {Format::kTurtle, Format::kTriG, Format::kNTriples, Format::kNQuads}) {
    EXPECT_TRUE(ReadRdf("", format, Named("x")).statements.empty());
    EXPECT_TRUE(ReadRdf("\n# nothing", format, Named("x")).statements.empty());
  }
}

struct Refusal {
  Format format;
  std::string text;
  std::string message;
};

TEST(TurtleReader, FaultsAreRefusedWithTheirPlace) {
  const std::string abc = "<http://e/a> <http://e/b> <http://e/c>";
  const std::vector<Refusal> refusals = {
      {Format::kTurtle, kPrefix + std::string("ex:a ex:b"), "x:2:9: expected object"},
      {Format::kTurtle, kPrefix + std::string("ex:a ex:b ex:c"), "x:2:14: unexpected end of file"},
      {Format::kTurtle, kPrefix + std::string("ex:a ex:b \"c"),
       "x:2:12: end of file in short string"},
      {Format::kTurtle, "<http://e/a", "x:1:12: end of file in an IRI"},
      {Format::kTurtle, kPrefix + std::string("ex:a ex:b foo:c ."),
       "x:2:11: the prefix 'foo:' is not declared"},
      {Format::kTurtle, kPrefix + std::string("ex:ä ex:ß \"äöü\" ; ; ex:c foo:d ."),
       "x:2:26: the prefix 'foo:' is not declared"},
      {Format::kTurtle, "<http://e/a b> a <http://e/c> .",
       "x:1:13: invalid IRI character (escape %20)"},
      {Format::kTurtle, "<http://e/a> a <c> .",
       "x:1:16: the IRI 'c' is relative, and no base IRI is known"},
      {Format::kTurtle, "<http://e/a> <http://e/b> \"x\"@en-toolongsubtag .",
       "x:1:31: 'en-toolongsubtag' is not a language tag"},
      {Format::kTurtle, "<http://e/a> _:b <http://e/c> .", "x:1:14: bad verb"},
      {Format::kTurtle, "<http://e/a> <http://e/b> _:-x .",
       "x:1:27: the label of a blank node begins with '-'"},
      {Format::kTurtle, "<http://e/g> { }",
       "x:1:14: '{' begins a graph: Turtle has none, TriG has"},
      {Format::kTurtle, std::string("<http://e/a> a <http://e/c> .\n\0 x", 33),
       "x:2:1: a NUL byte: this is not text"},
      {Format::kTurtle, "<http://e/a> a <http://e/é\xFF> .", "x:1:27: a byte that is not UTF-8"},
      {Format::kTurtle, "<http://e/a> <http://e/b> \"\\uD800\" .",
       "x:1:36: the term '??"
       "?' is not UTF-8"},
      {Format::kTriG, "<http://e/g> { " + abc, "x:1:54: unexpected end of file"},
      {Format::kNTriples, abc + " .\n" + abc, "x:2:38: unexpected end of file"},
      {Format::kNTriples, abc + " <http://e/g> .",
       "x:1:40: a fourth term: N-Triples has no graphs, N-Quads has"},
      {Format::kNTriples, abc + " ; <http://e/d> <http://e/e> .", "x:1:40: expected '<', not ';'"},
      {Format::kNTriples, abc + " . " + abc + " .",
       "x:1:1: this line does not hold one whole statement"},
      {Format::kNTriples, abc + " .\n" + abc + " .garbage\n" + abc + " .",
       "x:2:1: this line does not hold one whole statement"},
      {Format::kNQuads, abc + " \"g\" .", "x:1:40: expected '<', not '\"'"},
      {Format::kNQuads, abc + " <g> .", "x:1:42: missing IRI scheme"},
  };
  for (const Refusal& refusal : refusals) {
    EXPECT_EQ(MessageOf(refusal.text, refusal.format), refusal.message) << refusal.text;
    EXPECT_EQ(FaultOf(refusal.text, refusal.format, Named("x")).code(), Code::kInvalid);
  }
}

TEST(TurtleReader, BinaryFilesAreRefused) {
  std::string bytes;
  for (int i = 0; i < 512; ++i) bytes += static_cast<char>((i * 37 + 11) % 256);
  for (const Format format :
       {Format::kTurtle, Format::kTriG, Format::kNTriples, Format::kNQuads, Format::kRdfXml}) {
    EXPECT_EQ(FaultOf(bytes, format, Named("x")).code(), Code::kInvalid);
  }
}

TEST(TurtleReader, TenThousandBracketsAreTooDeep) {
  for (const char bracket : {'[', '('}) {
    const std::string text = "<http://e/a> <http://e/b>\n" + std::string(10000, bracket);
    const Error error = FaultOf(text, Format::kTurtle, Named("x"));
    EXPECT_EQ(error.code(), Code::kTooLarge);
    EXPECT_EQ(error.FullMessage(), "x:2:257: brackets nest deeper than 256");
  }
}

TEST(TurtleReader, BracketsInStringsIrisAndCommentsDoNotNest) {
  const std::string many(1000, '[');
  EXPECT_EQ(Turtle("<http://e/a> <http://e/((((> \"" + many + "\", '''" + many + "\n' " + many +
                   "''' . # " + many)
                .statements.size(),
            2u);
}

TEST(TurtleReader, NestingUpToTheLimitIsRead) {
  const std::string text =
      "<http://e/a> <http://e/b> " + std::string(256, '(') + std::string(256, ')') + " .";
  EXPECT_EQ(Turtle(text).statements.size(), 1u + 2 * 255);
}

TEST(TurtleReader, LimitsNameTheirPlace) {
  ReadOptions options = Named("x");
  options.max_statements = 2;
  const std::string line = "<http://e/a> <http://e/b> <http://e/c> .\n";
  const Error many = FaultOf(line + line + line, Format::kNTriples, options);
  EXPECT_EQ(many.code(), Code::kTooLarge);
  EXPECT_EQ(many.FullMessage(), "x:3:27: the document has more than 2 statements");

  options = Named("x");
  options.max_term_bytes = 100;
  const Error large =
      FaultOf(line + "<http://e/a> <http://e/b> \"" + std::string(101, 'y') + "\" .",
              Format::kTurtle, options);
  EXPECT_EQ(large.code(), Code::kTooLarge);
  EXPECT_EQ(large.FullMessage(), "x:2:28: a term is longer than 100 bytes");

  options = Named("x");
  options.max_bytes = 10;
  const Error huge = FaultOf(line, Format::kTurtle, options);
  EXPECT_EQ(huge.code(), Code::kTooLarge);
  EXPECT_EQ(huge.FullMessage(), "x: the document has 41 bytes; at most 10 are read");
}

}  // namespace
}  // namespace lares::rdf
