// RDF/XML: what is read, and what is refused where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using ::testing::ElementsAre;
using testing::FaultOf;
using ::testing::HasSubstr;
using testing::Lines;
using testing::MessageOf;
using testing::Named;
using ::testing::StartsWith;

constexpr const char* kHead =
    "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' xmlns:ex='http://e/'>\n";

std::string Rdf(const std::string& content) { return kHead + content + "\n</rdf:RDF>"; }

Document Read(const std::string& text) { return ReadRdf(text, Format::kRdfXml, Named("x")); }

TEST(RdfXmlReader, ReadsNodesPropertiesAndLiterals) {
  EXPECT_EQ(Lines(Read(Rdf("<ex:T rdf:about='http://e/a'><ex:p rdf:resource='http://e/b'/>"
                           "<ex:q xml:lang='EN-gb'>x &amp; y</ex:q></ex:T>"))),
            "<http://e/a> <http://e/p> <http://e/b>  .\n"
            "<http://e/a> <http://e/q> \"x & y\"@en-gb  .\n"
            "<http://e/a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://e/T>  .\n");
}

TEST(RdfXmlReader, EntitiesOfTheDocumentAreExpandedAlsoInNamespaces) {
  const Document document = Read(
      "<!DOCTYPE rdf:RDF [<!ENTITY r 'http://r/'><!ENTITY rs '&r;s#'>"
      "<!ENTITY rdf 'http://www.w3.org/1999/02/22-rdf-syntax-ns#'>]>\n"
      "<rdf:RDF xmlns:rdf='&rdf;' xmlns:s='&rs;'><s:T rdf:about='&rs;a'/></rdf:RDF>");
  EXPECT_EQ(Lines(document),
            "<http://r/s#a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://r/s#T>  .\n");
  EXPECT_EQ(document.prefixes.at("s"), "http://r/s#");
}

TEST(RdfXmlReader, BaseOfTheDocumentResolvesIdsAndRelativeIris) {
  const Document document = Read(
      "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' xmlns:ex='http://e/' "
      "xml:base='http://b/d/x.owl#'><ex:T rdf:ID='a'><ex:p rdf:resource='y'/></ex:T></rdf:RDF>");
  EXPECT_EQ(document.base_iri, "http://b/d/x.owl");
  EXPECT_THAT(Lines(document), HasSubstr("<http://b/d/x.owl#a> <http://e/p> <http://b/d/y>"));
}

TEST(RdfXmlReader, ImportsAreCollected) {
  const Document document =
      Read(Rdf("<owl:Ontology xmlns:owl='http://www.w3.org/2002/07/owl#' rdf:about='http://e/o'>"
               "<owl:imports rdf:resource='file://@PATH@/owl/a.owl'/></owl:Ontology>"));
  EXPECT_THAT(document.imports, ElementsAre("file://@PATH@/owl/a.owl"));
}

TEST(RdfXmlReader, OddNamespaceIsAWarning) {
  const Document document = Read(
      "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'\n"
      " xmlns:odd='http://e/a#  #'/>");
  ASSERT_EQ(document.remarks.size(), 1u);
  EXPECT_EQ(document.remarks[0].kind, Remark::Kind::kWarning);
  EXPECT_EQ(document.remarks[0].place.line, 2);
  EXPECT_THAT(document.remarks[0].message, HasSubstr("not a valid URI"));
}

TEST(RdfXmlReader, LatinOneIsRead) {
  const Document document =
      Read("<?xml version='1.0' encoding='ISO-8859-1'?>\n" +
           Rdf("<rdf:Description rdf:about='http://e/a' ex:p='gr\xFC\xDF'/>"));
  EXPECT_THAT(Lines(document), HasSubstr("\"grüß\""));
}

TEST(RdfXmlReader, PropertyAttributesKeepTheirLanguage) {
  const Document document =
      Read(Rdf("<rdf:Description rdf:about='http://e/a' xml:lang='de' ex:p='v'><ex:q>w</ex:q>"
               "</rdf:Description><rdf:Description rdf:about='http://e/b' ex:p='v'/>"));
  EXPECT_EQ(Lines(document),
            "<http://e/a> <http://e/p> \"v\"@de  .\n<http://e/a> <http://e/q> \"w\"@de  .\n"
            "<http://e/b> <http://e/p> \"v\"  .\n");
}

TEST(RdfXmlReader, LabelsAndGeneratedBlankNodesStayApart) {
  const Document document =
      Read(Rdf("<rdf:Description rdf:nodeID='gen1'><ex:p><ex:T/></ex:p></rdf:Description>"));
  EXPECT_EQ(document.statements.size(), 2u);
  EXPECT_EQ(document.terms.size(), 5u) << Lines(document);
}

TEST(RdfXmlReader, FaultsAreRefusedWithTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {"", "x:1:1: the document is empty"},
      {"  \n ", "x:1:1: the document is empty"},
      {"hello", "x:1:1: Start tag expected, '<' not found"},
      {Rdf("<ex:T rdf:about='http://e/a'>\n  <ex:p></ex:q></ex:T>"),
       "x:3:16: Opening and ending tag mismatch: p line 3 and q"},
      {Rdf("<ex:T rdf:about='http://e/a'>").substr(0, 117),
       "x:3:1: Premature end of data in tag T line 2"},
      {Rdf("<ex:T rdf:about='http://e/a' rdf:about='http://e/b'/>"),
       "x:2:52: Attribute rdf:about redefined"},
      {Rdf("<foo:T/>"), "x:2:7: Namespace prefix foo on T is not defined"},
      {Rdf("<ex:T rdf:about='&nope;a'/>"), "x:2:24: Entity 'nope' not defined"},
      {Rdf("<ex:T rdf:about='rel'/>"),
       "x:2:1: the IRI 'rel' is relative, and no base IRI is known"},
      {Rdf("<ex:T rdf:about='http://e/a b'/>"), "x:2:1: the IRI 'http://e/a b' has a space in it"},
      {Rdf("<ex:T>\n<ex:p xml:lang='en-waytoolong'>x</ex:p></ex:T>"),
       "x:3:1: 'en-waytoolong' is not a language tag"},
      {Rdf("<ex:T rdf:aboutEach='http://e/a'/>"),
       "x:2:33: rdf:aboutEach is no longer part of RDF/XML"},
  };
  for (const auto& [text, message] : refusals) {
    EXPECT_EQ(MessageOf(text, Format::kRdfXml), message) << text;
    EXPECT_EQ(FaultOf(text, Format::kRdfXml, Named("x")).code(), Code::kInvalid) << text;
  }
}

TEST(RdfXmlReader, NulAndInvalidUtf8AreRefusedWithTheirPlace) {
  EXPECT_THAT(MessageOf(Rdf(std::string("<ex:T>a\0b</ex:T>", 16)), Format::kRdfXml),
              StartsWith("x:2:"));
  EXPECT_THAT(MessageOf(Rdf("<ex:T rdf:about='http://e/\xFF'/>"), Format::kRdfXml),
              StartsWith("x:2:"));
}

TEST(RdfXmlReader, MalformedCommentIsNamedAndItsRepairOffered) {
  const Error error = FaultOf(Rdf("\n    <!-note to all-->\n<ex:T/>"), Format::kRdfXml, Named("x"));
  EXPECT_EQ(error.FullMessage(), "x:3:6: malformed comment '<!-note to all-->'");
  EXPECT_THAT(error.hint(), HasSubstr("--recover"));
}

TEST(RdfXmlReader, EntityBombIsRefusedAtOnce) {
  std::string text = "<!DOCTYPE rdf:RDF [\n<!ENTITY e0 'ha'>\n";
  for (int i = 1; i <= 12; ++i) {
    const std::string inner = "&e" + std::to_string(i - 1) + ";";
    text += "<!ENTITY e" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) text += inner;
    text += "'>\n";
  }
  text += "]>\n" + Rdf("<ex:T><ex:p>&e12;</ex:p></ex:T>");
  const auto start = std::chrono::steady_clock::now();
  const Error error = FaultOf(text, Format::kRdfXml, Named("x"));
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_THAT(error.FullMessage(), StartsWith("x:9:56: with the entity 'e7' the document expands"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(RdfXmlReader, ManySmallExpansionsAreBoundedToo) {
  ReadOptions options = Named("x");
  options.max_entity_bytes = 1000;
  std::string content;
  for (int i = 0; i < 20; ++i) content += "<ex:T ex:p='&e;'/>\n";
  const std::string text =
      "<!DOCTYPE rdf:RDF [<!ENTITY e '" + std::string(100, 'y') + "'>]>\n" + Rdf(content);
  const Error error = FaultOf(text, Format::kRdfXml, options);
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_THAT(error.FullMessage(), HasSubstr("more than 1000 bytes of entity text"));
}

TEST(RdfXmlReader, EntityThatContainsItselfIsRefused) {
  const std::string text =
      "<!DOCTYPE rdf:RDF [<!ENTITY a '&b;'><!ENTITY b '&a;'>]>\n" + Rdf("<ex:T ex:p='&a;'/>");
  EXPECT_EQ(FaultOf(text, Format::kRdfXml, Named("x")).code(), Code::kTooLarge);
}

TEST(RdfXmlReader, NothingFromOutsideIsRead) {
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {"<!DOCTYPE rdf:RDF [\n<!ENTITY a SYSTEM 'file:///etc/passwd'>]>\n" +
           Rdf("<ex:T><ex:p>&a;</ex:p></ex:T>"),
       "x:2:39: the external entity 'a' is never read"},
      {"<!DOCTYPE rdf:RDF [\n<!ENTITY % a SYSTEM 'http://e/x.dtd'> %a;]>\n" + Rdf(""),
       "x:2:37: the external entity 'a' is never read"},
      {"<!DOCTYPE rdf:RDF SYSTEM 'http://e/x.dtd'>\n" + Rdf(""),
       "x:1:42: a document type from outside, 'http://e/x.dtd', is never read"},
      {Rdf("<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='/etc/passwd'/>"),
       "x:2:74: XInclude is not followed"},
  };
  for (const auto& [text, message] : refusals) {
    const Error error = FaultOf(text, Format::kRdfXml, Named("x"));
    EXPECT_EQ(error.FullMessage(), message);
    EXPECT_EQ(error.code(), Code::kUnsupported);
  }
}

TEST(RdfXmlReader, TenThousandElementsAreTooDeep) {
  std::string content;
  for (int i = 0; i < 10000; ++i) content += i % 2 == 0 ? "<ex:T>\n" : "<ex:p>\n";
  const Error error = FaultOf(Rdf(content), Format::kRdfXml, Named("x"));
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_EQ(error.FullMessage(), "x:257:6: elements nest deeper than 256");
}

TEST(RdfXmlReader, LimitsNameTheirPlace) {
  ReadOptions options = Named("x");
  options.max_term_bytes = 100;
  const Error large = FaultOf(Rdf("<ex:T>\n<ex:p>" + std::string(101, 'y') + "</ex:p></ex:T>"),
                              Format::kRdfXml, options);
  EXPECT_EQ(large.code(), Code::kTooLarge);
  EXPECT_THAT(large.FullMessage(), HasSubstr("x:3:"));

  options = Named("x");
  options.max_statements = 1;
  const Error many = FaultOf(Rdf("<ex:T/>\n<ex:T/>"), Format::kRdfXml, options);
  EXPECT_EQ(many.code(), Code::kTooLarge);
  EXPECT_EQ(many.FullMessage(), "x:3:1: the document has more than 1 statements");
}

TEST(RdfXmlReader, DocumentsAreReadOnManyThreadsAtOnce) {
  const std::string good = Rdf("<ex:T rdf:about='http://e/a'><ex:p>x</ex:p></ex:T>");
  const std::string bad = Rdf("<ex:T rdf:about='http://e/a'><ex:p>x</ex:q></ex:T>");
  std::vector<std::thread> threads;
  std::vector<int> wrong(8, 0);
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 50; ++i) {
        if (Read(good).statements.size() != 2) ++wrong[static_cast<std::size_t>(t)];
        try {
          Read(bad);
          ++wrong[static_cast<std::size_t>(t)];
        } catch (const Error&) {
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, ::testing::Each(0));
}

}  // namespace
}  // namespace lares::rdf
