#include <gtest/gtest.h>

#include "ontology/triples/graph.h"
#include "tests/ontology/test_graph.h"

namespace lares::rdf {
namespace {

using lares::testing::ParseText;

TEST(GraphTest, RepeatedStatementsAreOneTriple) {
  Dictionary dictionary;
  const Graph graph = MakeGraph(ParseText(":b :p :c . :a :p :b . :b :p :c ."), "g", {}, dictionary);
  EXPECT_EQ(graph.triples.size(), 2U);
  EXPECT_TRUE(std::is_sorted(graph.triples.begin(), graph.triples.end()));
}

TEST(GraphTest, BlankNodesOfTwoDocumentsNeverMeet) {
  Dictionary dictionary;
  const Document document = ParseText("_:x :p _:y . _:y :p _:x .");
  const Graph a = MakeGraph(document, "a", {}, dictionary);
  const Graph b = MakeGraph(document, "b", {}, dictionary);
  for (const Triple& triple : a.triples) {
    EXPECT_FALSE(std::binary_search(b.triples.begin(), b.triples.end(), triple));
  }
  EXPECT_EQ(MakeGraph(document, "a", {}, dictionary).triples, a.triples);
}

TEST(GraphTest, NamesThatDifferInPunctuationStayApart) {
  Dictionary dictionary;
  const Document document = ParseText("_:x :p _:x .");
  const TermId dash = MakeGraph(document, "a-b", {}, dictionary).triples[0].subject;
  const TermId line = MakeGraph(document, "a_b", {}, dictionary).triples[0].subject;
  EXPECT_NE(dash, line);
  EXPECT_EQ(dictionary.Get(dash).value, "a_2db.x");
}

TEST(GraphTest, AliasesAreAppliedToIrisAndTheSpellingIsKept) {
  Dictionary dictionary;
  const AliasTable aliases({{"http://old/", "http://new/", "renamed", false}});
  const Graph graph =
      MakeGraph(ParseText("<http://old/a> :p \"<http://old/a>\" , \"1\"^^<http://old/type> ."), "g",
                aliases, dictionary);
  const TermId canonical = dictionary.FindIri("http://new/a").value();
  EXPECT_EQ(graph.triples[0].subject, canonical);
  ASSERT_EQ(graph.as_written.size(), 1U);
  EXPECT_EQ(dictionary.Get(graph.as_written.at(canonical)).value, "http://old/a");
  EXPECT_TRUE(dictionary.Find(Term::Literal("1", "http://old/type").view()).has_value());
}

TEST(GraphTest, NamedGraphsAreMerged) {
  Dictionary dictionary;
  Document document = ParseText(":a :p :b . :c :p :d .");
  document.terms.push_back(Term::Iri("http://example.org/g"));
  document.statements[0].graph = static_cast<std::uint32_t>(document.terms.size() - 1);
  EXPECT_EQ(MakeGraph(document, "g", {}, dictionary).triples.size(), 2U);
}

TEST(GraphTest, EmptyDocumentIsAnEmptyGraph) {
  Dictionary dictionary;
  EXPECT_TRUE(MakeGraph({}, "g", {}, dictionary).triples.empty());
  EXPECT_EQ(dictionary.size(), 0U);
}

}  // namespace
}  // namespace lares::rdf
