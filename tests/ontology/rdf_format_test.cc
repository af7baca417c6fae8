#include <gtest/gtest.h>

#include "ontology/rdf/document.h"

namespace lares::rdf {
namespace {

TEST(RdfFormat, EachFormatsMediaTypeIsRecognised) {
  for (const Format format :
       {Format::kRdfXml, Format::kTurtle, Format::kTriG, Format::kNTriples, Format::kNQuads,
        Format::kJsonLd, Format::kOwlFunctional, Format::kOwlXml}) {
    EXPECT_EQ(GuessFormat(MediaType(format), "", ""), format);
  }
}

TEST(RdfFormat, MediaTypeWinsOverNameAndItsParametersAreIgnored) {
  EXPECT_EQ(GuessFormat("Text/Turtle; charset=utf-8", "a.nt", "<rdf:RDF>"), Format::kTurtle);
}

TEST(RdfFormat, FileNameDecidesWhereTheMediaTypeIsVague) {
  EXPECT_EQ(GuessFormat("application/octet-stream", "dir/A.TTL", ""), Format::kTurtle);
  EXPECT_EQ(GuessFormat("", "a.owl", ""), Format::kRdfXml);
  EXPECT_EQ(GuessFormat("", "a.rdf", ""), Format::kRdfXml);
  EXPECT_EQ(GuessFormat("", "a.trig", ""), Format::kTriG);
  EXPECT_EQ(GuessFormat("", "a.nt", ""), Format::kNTriples);
  EXPECT_EQ(GuessFormat("", "a.nq", ""), Format::kNQuads);
  EXPECT_EQ(GuessFormat("", "a.jsonld", ""), Format::kJsonLd);
}

TEST(RdfFormat, OwlFileInTurtleIsSeenByItsFirstBytes) {
  EXPECT_EQ(GuessFormat("", "a.owl", "# hello\n@prefix : <http://e/> ."), Format::kTurtle);
}

TEST(RdfFormat, OwlsOwnSyntaxesAreSeenWhateverTheyAreSaidToBe) {
  const std::string functional = "# a comment\nPrefix ( :=<http://e/> )";
  const std::string xml =
      "<?xml version='1.0'?>\n<!DOCTYPE Ontology [ <!ENTITY e 'x'> ]>\n<!-- > -->\n"
      "<Ontology\n xmlns='http://www.w3.org/2002/07/owl#' ontologyIRI='http://e/'>";
  for (const std::string_view type :
       {"", "application/rdf+xml", "application/xml", "application/octet-stream"}) {
    for (const std::string_view name : {"", "a.owl", "a.xml", "a.rdf"}) {
      if (type.starts_with("application/octet") && name.empty()) continue;
      EXPECT_EQ(GuessFormat(type, name, functional), Format::kOwlFunctional) << type << name;
      EXPECT_EQ(GuessFormat(type, name, xml), Format::kOwlXml) << type << name;
    }
  }
  EXPECT_EQ(GuessFormat("", "a.ofn", ""), Format::kOwlFunctional);
  EXPECT_EQ(GuessFormat("", "a.OWX", ""), Format::kOwlXml);
  EXPECT_EQ(GuessFormat("", "", "<o:Ontology xmlns:o='http://www.w3.org/2002/07/owl#'>"),
            Format::kOwlXml);
  // RDF/XML of which the first element is an ontology.
  EXPECT_EQ(GuessFormat("", "a.owl",
                        "<rdf:RDF xmlns:owl='http://www.w3.org/2002/07/owl#'><owl:Ontology/>"),
            Format::kRdfXml);
}

TEST(RdfFormat, FirstBytesDecideWhereNothingElseTells) {
  EXPECT_EQ(GuessFormat("", "", "\xEF\xBB\xBF<?xml version='1.0'?>"), Format::kRdfXml);
  EXPECT_EQ(GuessFormat("", "", "\n <!-- x --><rdf:RDF>"), Format::kRdfXml);
  EXPECT_EQ(GuessFormat("", "", "<rdf:RDF xmlns:rdf='x'>"), Format::kRdfXml);
  EXPECT_EQ(GuessFormat("", "", "<http://e/a> a <http://e/b> ."), Format::kTurtle);
  EXPECT_EQ(GuessFormat("", "", "PREFIX e: <http://e/>"), Format::kTurtle);
  EXPECT_EQ(GuessFormat("", "", "{ <a> <b> <c> }"), Format::kTriG);
  EXPECT_EQ(GuessFormat("", "", "\n{ \"@context\": {} }"), Format::kJsonLd);
  EXPECT_EQ(GuessFormat("", "", "[ {\"@id\": \"a\"} ]"), Format::kJsonLd);
  EXPECT_EQ(GuessFormat("", "", "[ a <http://e/b> ] ."), Format::kTurtle);
}

TEST(RdfFormat, OtherFormatsAreRefused) {
  struct Unknown {
    std::string type, name, bytes;
  };
  for (const Unknown& unknown :
       {Unknown{"application/json", "a.ttl", ""}, Unknown{"", "", ""}, Unknown{"", "", "hello"},
        Unknown{"", "a.owl", "Prefix: : <http://e/>"}}) {
    try {
      GuessFormat(unknown.type, unknown.name, unknown.bytes);
      ADD_FAILURE() << unknown.type << unknown.name << unknown.bytes;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kUnsupported);
      EXPECT_FALSE(error.hint().empty());
    }
  }
}

}  // namespace
}  // namespace lares::rdf
