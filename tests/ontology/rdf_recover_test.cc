// `--recover`: the three faults that are mended, and what is left alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using testing::FaultOf;
using ::testing::HasSubstr;
using testing::Lines;
using testing::Named;

constexpr const char* kHead =
    "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' xmlns:ex='http://e/'>\n";

std::string Rdf(const std::string& content) { return kHead + content + "\n</rdf:RDF>"; }

ReadOptions Recovering() {
  ReadOptions options = Named("x");
  options.recover = true;
  return options;
}

Document Recover(const std::string& text) { return ReadRdf(text, Format::kRdfXml, Recovering()); }

std::string Repairs(const Document& document) {
  std::string text;
  for (const Remark& remark : document.remarks) {
    if (remark.kind != Remark::Kind::kRepair) continue;
    text += ToString(remark.place) + " " + remark.message + "\n";
  }
  return text;
}

std::string Fault(const std::string& text) {
  return FaultOf(text, Format::kRdfXml, Recovering()).FullMessage();
}

TEST(Recover, SoundDocumentNeedsNoRepair) {
  const Document document = Recover(Rdf("<!-- fine --><ex:T ex:p='a &amp; b'/>"));
  EXPECT_EQ(document.statements.size(), 2u);
  EXPECT_EQ(Repairs(document), "");
}

TEST(Recover, CommentWithOneDashIsReadAsAComment) {
  const Document document = Recover(Rdf("<ex:T/>\n  <!-for the HMI-->\n  <ex:T/>"));
  EXPECT_EQ(document.statements.size(), 2u);
  EXPECT_EQ(Repairs(document), "x:3:3 malformed comment '<!-for the HMI-->'; read as a comment\n");
}

TEST(Recover, OtherSpellingsOfCommentsAreReadToo) {
  EXPECT_EQ(Recover(Rdf("<! -- a -- ><!-b-><ex:T/>")).statements.size(), 1u);
}

TEST(Recover, DashesInsideACommentAreReadAsPartOfIt) {
  const Document document =
      Recover(Rdf("<ex:T><ex:p>a<!-- x -- y --- z --->b</ex:p></ex:T>\n<!----------->"));
  EXPECT_THAT(Lines(document), HasSubstr("\"ab\""));
  EXPECT_EQ(Repairs(document),
            "x:2:14 malformed comment: it has '--' inside; read as part of it\n"
            "x:3:1 malformed comment: it has '--' inside; read as part of it\n");
}

TEST(Recover, CommentsInTheDocumentTypeAreMended) {
  EXPECT_EQ(Recover("<!DOCTYPE rdf:RDF [\n<!- a -->\n<!ENTITY e 'http://e/'>\n]>\n" +
                    Rdf("<ex:T rdf:about='&e;a'/>"))
                .statements.size(),
            1u);
}

TEST(Recover, UnterminatedCommentIsRefused) {
  EXPECT_EQ(Fault(Rdf("<!-- a --><ex:T/>\n<!-- never ends <ex:T/>")),
            "x:3:1: Comment not terminated");
  EXPECT_THAT(Fault(Rdf("<ex:T/>\n<!- never ends <ex:T/>")), HasSubstr("x:3:"));
}

TEST(Recover, CommentThatSwallowsAnotherIsRefused) {
  EXPECT_EQ(Fault(Rdf("<!-- a -> <ex:T/>\n<!-- b -->")),
            "x:2:1: a comment begins inside this comment: where this one ends is not clear");
}

TEST(Recover, UndeclaredEntityIsReadAsTheNamespaceOfThatPrefix) {
  const Document document =
      Recover(Rdf("<ex:T rdf:about='&ex;a'>\n<ex:p rdf:datatype='&xsd;int'>&ex;</ex:p></ex:T>"));
  EXPECT_EQ(Lines(document),
            "<http://e/a> <http://e/p> \"http://e/\"^^<http://www.w3.org/2001/XMLSchema#int>  .\n"
            "<http://e/a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://e/T>  .\n");
  EXPECT_EQ(Repairs(document),
            "x:2:18 undeclared entity 'ex'; read as the namespace <http://e/>\n"
            "x:3:21 undeclared entity 'xsd'; read as the namespace "
            "<http://www.w3.org/2001/XMLSchema#>\n"
            "x:3:31 undeclared entity 'ex'; read as the namespace <http://e/>\n");
}

TEST(Recover, NamespaceOfAPrefixMayComeFromAnEntity) {
  const Document document = Recover(
      "<!DOCTYPE rdf:RDF [<!ENTITY base 'http://e/'>]>\n<rdf:RDF xmlns:rdf='&rdf;' "
      "xmlns:own='&base;own#'><own:T rdf:about='&own;a'/></rdf:RDF>");
  EXPECT_THAT(Lines(document), HasSubstr("<http://e/own#a>"));
}

TEST(Recover, EntityOfUnknownNamespaceIsRefused) {
  EXPECT_EQ(Fault(Rdf("<ex:T rdf:about='&nope;a'/>")), "x:2:24: Entity 'nope' not defined");
}

TEST(Recover, EntityWhosePrefixHasTwoNamespacesIsRefused) {
  EXPECT_EQ(Fault(Rdf("<ex:T rdf:about='&a;b'>\n<ex:p xmlns:a='http://1/'/><ex:p "
                      "xmlns:a='http://2/'/></ex:T>")),
            "x:2:18: the entity 'a' is not declared, and the document binds the prefix to two "
            "namespaces");
}

TEST(Recover, ResourceOnANodeIsReadAsAbout) {
  const Document document =
      Recover(Rdf("<ex:T rdf:about='http://e/a'><ex:p>\n  <ex:T rdf:resource='http://e/b'/>"
                  "</ex:p></ex:T>"));
  EXPECT_THAT(Lines(document), HasSubstr("<http://e/a> <http://e/p> <http://e/b>"));
  EXPECT_EQ(Repairs(document),
            "x:3:9 misplaced rdf:resource on a node element; read as rdf:about\n");
}

TEST(Recover, ResourceOnANodeThatHasANameIsRefused) {
  EXPECT_EQ(Fault(Rdf("<ex:T rdf:about='http://e/a' rdf:resource='http://e/b'/>")),
            "x:2:30: rdf:resource on a node element that has rdf:about: which of them names it is "
            "not clear");
}

TEST(Recover, ResourceBesideTheSameNodeIsDropped) {
  const Document document =
      Recover(Rdf("<ex:T rdf:about='http://e/a'>\n<ex:p rdf:resource='http://e/b'>\n"
                  "<ex:U rdf:about='http://e/b'/></ex:p></ex:T>"));
  EXPECT_EQ(document.statements.size(), 3u);
  EXPECT_THAT(Lines(document), HasSubstr("<http://e/a> <http://e/p> <http://e/b>"));
  EXPECT_EQ(Repairs(document),
            "x:3:7 misplaced rdf:resource on a property element that has content; dropped, because "
            "the element inside is about the same\n");
}

TEST(Recover, ResourceBesideOtherContentIsRefused) {
  for (const std::string content : {"text", "<ex:U rdf:about='http://e/c'/>", "<ex:U/>",
                                    "<ex:U rdf:about='http://e/b'/>text"}) {
    EXPECT_EQ(Fault(Rdf("<ex:T>\n<ex:p rdf:resource='http://e/b'>" + content + "</ex:p></ex:T>")),
              "x:3:7: rdf:resource on a property element that has content: which of them is meant "
              "is not clear");
  }
}

TEST(Recover, PropertiesOfParseTypeResourceAreNoNodes) {
  const Document document =
      Recover(Rdf("<ex:T rdf:about='http://e/a'><ex:p rdf:parseType='Resource'><ex:q "
                  "rdf:resource='http://e/b'/></ex:p></ex:T>"));
  EXPECT_EQ(Repairs(document), "");
  EXPECT_THAT(Lines(document), HasSubstr("<http://e/q> <http://e/b>"));
}

TEST(Recover, OtherFaultsAreStillRefusedWithTheOriginalPlace) {
  EXPECT_EQ(Fault(Rdf("<!-long comment-->&rdf; <ex:T>\n<!-a--> <ex:p></ex:q></ex:T>")),
            "x:3:22: Opening and ending tag mismatch: p line 3 and q");
  EXPECT_THAT(Fault(Rdf("<ex:T>").substr(0, 95)), HasSubstr("x:3:2"));
}

}  // namespace
}  // namespace lares::rdf
