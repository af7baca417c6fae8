// What queries mean, where the W3C's tests say little.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ontology/rdf/writer.h"
#include "reasoner/sparql/results.h"
#include "tests/reasoner/sparql/sparql_support.h"

namespace lares::sparql::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

Error FaultOf(std::string_view query) {
  try {
    Parse(query, {});
  } catch (const Error& error) {
    return error;
  }
  return Error(Code::kInternal, "accepted");
}

TEST(SparqlParse, AFaultNamesLineAndColumn) {
  const Error error = FaultOf("SELECT ?x\nWHERE { ?x ?p }");
  EXPECT_EQ(error.code(), Code::kInvalid);
  ASSERT_TRUE(error.place());
  EXPECT_EQ(error.place()->line, 2);
  EXPECT_EQ(error.place()->column, 15);
}

TEST(SparqlParse, ColumnsCountCharacters) {
  EXPECT_EQ(FaultOf("SELECT * { ?x ?p \"ééé\" ] }").place()->column, 24);
}

TEST(SparqlParse, UpdatesAreRefusedAsSuch) {
  EXPECT_EQ(FaultOf("INSERT DATA { <a:b> <a:c> 1 }").code(), Code::kUnsupported);
}

TEST(SparqlParse, DeepNestingAndManyPartsAreRefused) {
  std::string groups, brackets, chain = "1";
  for (int i = 0; i < 100'000; ++i) {
    groups += "{";
    brackets += "(";
    chain += "+1";
  }
  EXPECT_EQ(FaultOf("SELECT * " + groups).code(), Code::kTooLarge);
  EXPECT_EQ(FaultOf("SELECT * { FILTER " + brackets).code(), Code::kTooLarge);
  EXPECT_EQ(FaultOf("SELECT * { FILTER (" + chain + ") }").code(), Code::kTooLarge);
  EXPECT_EQ(FaultOf(std::string(2u << 20, ' ')).code(), Code::kTooLarge);
}

TEST(SparqlQuery, AnOptionalPartSeesItsOuterPatternOnlyByItsCondition) {
  const World world(":a :p 1 . :a :q 2 .");
  // The nested filter has no ?x: an error, so nothing is added.
  EXPECT_THAT(Rows(world, "SELECT ?x ?y { :a :p ?x OPTIONAL { { :a :q ?y FILTER(?x = 1) } } }"),
              ElementsAre("x=1"));
  EXPECT_THAT(Rows(world, "SELECT ?x ?y { :a :p ?x OPTIONAL { :a :q ?y FILTER(?x = 1) } }"),
              ElementsAre("x=1 y=2"));
}

TEST(SparqlQuery, PatternsAreAnsweredFromTheInsideOut) {
  const World world(":a :p :b . :c :q :d .");
  // ?x of the inner OPTIONAL is bound inside before it meets the outer one.
  EXPECT_THAT(Rows(world, "SELECT * { ?x :p :b . { :c :q :d OPTIONAL { ?x :q :d } } }"), IsEmpty());
}

TEST(SparqlQuery, MinusNeedsASharedVariable) {
  const World world(":a :p 1 . :b :p 2 .");
  EXPECT_THAT(Rows(world, "SELECT ?s { ?s :p ?o MINUS { ?x :p 1 } }"),
              UnorderedElementsAre("s=:a", "s=:b"));
  EXPECT_THAT(Rows(world, "SELECT ?s { ?s :p ?o MINUS { ?s :p 1 } }"), ElementsAre("s=:b"));
}

TEST(SparqlQuery, ExistsSeesTheRowThatItIsAskedFor) {
  const World world(":a :p 1 . :b :p 2 . :a :q 1 . :b :q 3 .");
  EXPECT_THAT(Rows(world, "SELECT ?s { ?s :p ?o FILTER EXISTS { ?s :q ?z FILTER(?z = ?o) } }"),
              ElementsAre("s=:a"));
  EXPECT_THAT(Rows(world, "SELECT ?s { ?s :p ?o FILTER NOT EXISTS { ?s :q ?z FILTER(?z = ?o) } }"),
              ElementsAre("s=:b"));
}

TEST(SparqlQuery, PathsEndInCircles) {
  const World world(":a :p :b . :b :p :c . :c :p :a .");
  EXPECT_THAT(Rows(world, "SELECT ?x { :a :p+ ?x }"), UnorderedElementsAre("x=:a", "x=:b", "x=:c"));
  EXPECT_THAT(Rows(world, "SELECT ?x { :a (:p/:p)* ?x } ORDER BY ?x"),
              ElementsAre("x=:a", "x=:b", "x=:c"));
  EXPECT_THAT(Rows(world, "SELECT (COUNT(*) AS ?n) { ?x :p* ?y }"), ElementsAre("n=9"));
  EXPECT_THAT(Rows(world, "SELECT ?x { ?x ^:p|!:q :a } ORDER BY ?x"), ElementsAre("x=:b", "x=:c"));
}

TEST(SparqlQuery, ASubSelectHidesWhatItDoesNotProject) {
  const World world(":a :p 1 . :b :p 2 . :b :q :x .");
  EXPECT_THAT(Rows(world,
                   "SELECT ?s ?o { ?o :q :x . { SELECT ?s { ?s :p ?o } ORDER BY DESC(?o) "
                   "LIMIT 1 } }"),
              ElementsAre("s=:b o=:b"));
}

TEST(SparqlQuery, NumbersArePromotedAndDecimalsExact) {
  const World world("");
  EXPECT_THAT(Rows(world,
                   "SELECT (0.1 + 0.2 AS ?a) (1 / 4 AS ?b) (1 + 1.0e0 AS ?c) (7 - 2 AS ?d) "
                   "(1 / 0 AS ?e) {}"),
              ElementsAre("a=0.3 b=0.25 c=2.0E0 d=5"));
  EXPECT_THAT(Rows(world, "ASK { FILTER(0.1 + 0.2 = 0.3) }"), ElementsAre("yes"));
}

TEST(SparqlQuery, AggregatesGroupAndSkipEmptyGroups) {
  const World world(":a :p 1, 2 . :b :p 5 .");
  EXPECT_THAT(Rows(world, "SELECT ?s (SUM(?o) AS ?n) { ?s :p ?o } GROUP BY ?s HAVING(SUM(?o) < 4)"),
              ElementsAre("s=:a n=3"));
  EXPECT_THAT(Rows(world, "SELECT (COUNT(*) AS ?n) { ?s :none ?o }"), ElementsAre("n=0"));
  EXPECT_THAT(Rows(world, "SELECT ?s (COUNT(*) AS ?n) { ?s :none ?o } GROUP BY ?s"), IsEmpty());
}

TEST(SparqlQuery, RegularExpressionsAreThoseOfXpath) {
  const World world("");
  const std::string_view query =
      "SELECT (REPLACE('abcd', 'b(c)', '[$1]') AS ?a) (REGEX('ÄB', 'äb', 'i') AS ?b) "
      "(REGEX('a', 'a(?=b)') AS ?c) (REPLACE('aa', 'x*', '-') AS ?d) {}";
  EXPECT_THAT(Rows(world, query), ElementsAre("a=\"a[c]d\" b=true"));
}

TEST(SparqlQuery, BlankNodesOfAFunctionAreOnesOwnForEachSolution) {
  const World world(":a :p 1, 2 .");
  EXPECT_THAT(
      Rows(world, "SELECT (COUNT(DISTINCT ?b) AS ?n) { ?s :p ?o BIND(BNODE(\"x\") AS ?b) }"),
      ElementsAre("n=2"));
}

TEST(SparqlQuery, NamedGraphsAreTheAssertedTriplesOfTheirDocuments) {
  const World world(":a :p 1 .");
  const Dataset dataset = DatasetOf(world.view, [](std::string_view name) {
    return DocumentGraphIri("recipe:" + std::string(name));
  });
  ASSERT_EQ(dataset.named.size(), 1u);
  EXPECT_EQ(dataset.named[0].iri, "https://w3id.org/lares/documents/recipe/test");
  const Answer answer = Evaluate(Parse("SELECT ?g { GRAPH ?g { ?s ?p 1 } }"), dataset);
  ASSERT_EQ(answer.rows.size(), 1u);
  EXPECT_EQ(answer.rows[0][0]->value, dataset.named[0].iri);
  EXPECT_THROW(Evaluate(Parse("ASK FROM <http://none/> {}"), dataset), Error);
  EXPECT_TRUE(Evaluate(Parse("ASK FROM <https://w3id.org/lares/documents/recipe/test> { ?s ?p 1 }"),
                       dataset)
                  .yes);
}

TEST(SparqlQuery, ServiceIsRefusedUnlessSilent) {
  const World world(":a :p 1 .");
  try {
    Rows(world, "SELECT * { SERVICE <http://elsewhere/> { ?s ?p ?o } }");
    FAIL() << "answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kUnsupported);
  }
  EXPECT_THAT(Rows(world, "SELECT * { ?s :p ?o SERVICE SILENT <http://elsewhere/> { ?s :q ?z } }"),
              ElementsAre("s=:a o=1"));
}

TEST(SparqlQuery, DescribeFollowsBlankNodes) {
  const World world(":a :p [ :q 1 ] . :b :p 2 .");
  const rdf::Document document =
      Construct(Parse("DESCRIBE <http://example.org/a>"), world.dataset(), {}, {});
  EXPECT_EQ(document.statements.size(), 2u);
}

TEST(SparqlQuery, ConstructLeavesOutWhatIsNoTriple) {
  const World world(":a :p 1 .");
  const rdf::Document document = Construct(
      Parse("CONSTRUCT { ?o <a:b> ?s . ?s <a:b> [] } { ?s ?p ?o }"), world.dataset(), {}, {});
  EXPECT_EQ(document.statements.size(), 1u);
  EXPECT_THAT(rdf::WriteRdf(document, rdf::Format::kNTriples), HasSubstr("<a:b> _:"));
}

TEST(SparqlExplain, TheSelectivePatternComesFirst) {
  std::string turtle = ":rare :is :here .";
  for (int i = 0; i < 200; ++i) turtle += " :x" + std::to_string(i) + " :kind :common .";
  turtle += " :rare :kind :common .";
  const World world(turtle);
  const Query query = Parse(
      "PREFIX : <http://example.org/> SELECT * { ?x :kind :common . ?x :is :here FILTER(?x != 1) "
      "}");
  const std::string text = Explain(query, world.dataset(), ExplainFormat::kText, Limits{});
  EXPECT_LT(text.find("?x :is :here"), text.find("?x :kind :common")) << text;
  EXPECT_THAT(text, HasSubstr("gave 1"));
  EXPECT_THAT(Explain(query, world.dataset(), ExplainFormat::kJson), HasSubstr("\"estimate\""));
}

TEST(SparqlResults, EveryFormatEscapesItsOwnWay) {
  Answer answer;
  answer.variables = {"a", "b"};
  answer.rows.push_back({rdf::Term::Literal("x,\"<&\n", "", "en"), std::nullopt});
  answer.rows.push_back({rdf::Term::Iri("http://a/"),
                         rdf::Term::Literal("5", "http://www.w3.org/2001/XMLSchema#integer")});
  EXPECT_EQ(WriteAnswer(ResultFormat::kCsv, answer), "a,b\r\n\"x,\"\"<&\n\",\r\nhttp://a/,5\r\n");
  EXPECT_EQ(WriteAnswer(ResultFormat::kTsv, answer),
            "?a\t?b\n\"x,\\\"<&\\n\"@en\t\n<http://a/>\t5\n");
  EXPECT_THAT(WriteAnswer(ResultFormat::kJson, answer),
              HasSubstr(R"({"a":{"type":"literal","xml:lang":"en","value":"x,\"<&\n"}})"));
  EXPECT_THAT(WriteAnswer(ResultFormat::kXml, answer),
              HasSubstr("<literal xml:lang=\"en\">x,&quot;&lt;&amp;\n</literal>"));
  EXPECT_EQ(ResultFormatOf("text/csv; charset=utf-8"), ResultFormat::kCsv);
  EXPECT_EQ(ResultFormatOf("text/turtle"), std::nullopt);
}

TEST(SparqlResults, AWriterStopsWhenItsReaderIsGone) {
  int pieces = 0;
  ResultWriter writer(ResultFormat::kCsv, {"a"}, [&](std::string_view) { return ++pieces < 2; });
  const rdf::Term term = rdf::Term::Literal(std::string(20'000, 'x'));
  const std::vector<std::optional<rdf::TermView>> cells{term.view()};
  EXPECT_TRUE(writer.Row(cells));
  EXPECT_FALSE(writer.Row(cells));
  EXPECT_FALSE(writer.Row(cells));
  EXPECT_EQ(pieces, 2);
}

}  // namespace
}  // namespace lares::sparql::testing
