#include "ontology/rdf/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf::testing {
namespace {

const std::string kPrefixes =
    "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . ";

Document Turtle(const std::string& text) {
  return ReadRdf(kPrefixes + text, Format::kTurtle, Named("x"));
}

void ExpectMerged(const std::vector<Document>& documents, const std::string& expected) {
  const Document merged = MergeOntologies(documents);
  EXPECT_TRUE(AreIsomorphic(merged, Turtle(expected))) << Lines(merged);
}

TEST(MergeOntologies, BlankNodesOfDocumentsStayApart) {
  ExpectMerged({Turtle("_:x :p 1 ."), Turtle("_:x :p 2 .")}, "_:x :p 1 . _:y :p 2 .");
}

TEST(MergeOntologies, OneHeaderImportsWhatIsNotMerged) {
  ExpectMerged(
      {Turtle(":o a owl:Ontology ; owl:versionIRI :o1 ; owl:imports :q2 , :x ; rdfs:label \"o\" ."),
       Turtle(":q a owl:Ontology ; owl:versionIRI :q2 ; owl:imports :o , :y ; rdfs:label \"q\" ."),
       Turtle("[] a owl:Ontology ; rdfs:label \"nameless\" .")},
      ":o a owl:Ontology ; owl:versionIRI :o1 ; owl:imports :x , :y ; "
      "rdfs:label \"o\" , \"nameless\" . :q rdfs:label \"q\" .");
}

TEST(MergeOntologies, DocumentsWithoutAHeaderStayWithoutOne) {
  ExpectMerged({Turtle(":a :p :b ."), Turtle(":c :p :d .")}, ":a :p :b . :c :p :d .");
  ExpectMerged({Turtle(":a :p :b ."), Turtle(":o a owl:Ontology .")},
               ":a :p :b . :o a owl:Ontology .");
}

TEST(MergeOntologies, PrefixMeansWhatTheFirstDocumentSays) {
  const Document other = ReadRdf("@prefix : <http://f/> . @prefix f: <http://f/> . :a :p :b .",
                                 Format::kTurtle, Named("y"));
  const Document merged = MergeOntologies({Turtle(":a :p :b ."), other});
  EXPECT_EQ(merged.prefixes.at(""), "http://e/");
  EXPECT_EQ(merged.prefixes.at("f"), "http://f/");
}

TEST(MergeOntologies, OneDocumentIsItself) {
  ExpectMerged({Turtle(":o a owl:Ontology . :q a owl:Ontology .")},
               ":o a owl:Ontology . :q a owl:Ontology .");
  EXPECT_TRUE(MergeOntologies({}).statements.empty());
}

}  // namespace
}  // namespace lares::rdf::testing
