// JSON-LD 1.1, case by case: each rule of the standard beside the statements that follow from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using testing::AreIsomorphic;
using testing::FaultOf;
using ::testing::HasSubstr;
using testing::Lines;
using testing::Named;

ReadOptions Based() {
  ReadOptions options = Named("x");
  options.base_iri = "http://base/dir/doc";
  return options;
}

Document JsonLd(const std::string& text) { return ReadRdf(text, Format::kJsonLd, Based()); }

struct Case {
  const char* rule;
  const char* json;
  const char* turtle;  // TriG, with prefixes e:, xsd:, rdf:
};

constexpr const char* kPrefixes =
    "@prefix e: <http://e/> . @prefix xsd: <http://www.w3.org/2001/XMLSchema#> . "
    "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> . @base <http://base/dir/doc> .\n";

void ExpectCases(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const Document wanted = ReadRdf(kPrefixes + std::string(one.turtle), Format::kTriG, Based());
    try {
      const Document got = JsonLd(one.json);
      EXPECT_TRUE(AreIsomorphic(got, wanted)) << one.rule << "\n"
                                              << one.json << "\ngave\n"
                                              << Lines(got) << "wanted\n"
                                              << Lines(wanted);
    } catch (const Error& error) {
      ADD_FAILURE() << one.rule << "\n" << one.json << "\n" << error.FullMessage();
    }
  }
}

TEST(JsonLdReader, NodesTypesAndValues) {
  ExpectCases({
      {"expanded form", R"([{"@id":"http://e/a","http://e/p":[{"@value":"x"}]}])", "e:a e:p 'x' ."},
      {"one type", R"({"@id":"http://e/a","@type":"http://e/T"})", "e:a a e:T ."},
      {"several types", R"({"@id":"http://e/a","@type":["http://e/T","http://e/U"]})",
       "e:a a e:T, e:U ."},
      {"no @id is a blank node", R"({"http://e/p":"x"})", "[] e:p 'x' ."},
      {"labels name one node",
       R"({"@graph":[{"@id":"_:b","http://e/p":{"@id":"_:b"}},{"@id":"_:b","http://e/q":1}]})",
       "_:b e:p _:b ; e:q 1 ."},
      {"generated labels do not meet written ones",
       R"([{"http://e/p":1},{"@id":"_:gen1","http://e/p":2}])", "[] e:p 1 . [] e:p 2 ."},
      {"nested nodes", R"({"@id":"http://e/a","http://e/p":{"http://e/q":{"@id":"http://e/b"}}})",
       "e:a e:p [ e:q e:b ] ."},
      {"null says nothing", R"({"@id":"http://e/a","http://e/p":null,"http://e/q":[null,"x"]})",
       "e:a e:q 'x' ."},
      {"numbers",
       R"({"@id":"http://e/a","http://e/p":[1,-0,5.0,1.5,1e21,100000000000000000000,5e-324]})",
       "e:a e:p 1, 0, 5, '1.5E0'^^xsd:double, '1.0E21'^^xsd:double, 100000000000000000000, "
       "'4.940656458412465E-324'^^xsd:double ."},
      {"a whole number where a double is asked for",
       R"({"@context":{"p":{"@id":"http://e/p","@type":"http://www.w3.org/2001/XMLSchema#double"}},
           "@id":"http://e/a","p":[5, 0.1]})",
       "e:a e:p '5.0E0'^^xsd:double, '1.0E-1'^^xsd:double ."},
      {"true and false", R"({"@id":"http://e/a","http://e/p":[true,false]})",
       "e:a e:p true, false ."},
      {"typed and tagged texts",
       R"({"@id":"http://e/a","http://e/p":[{"@value":"x","@type":"http://e/D"},
           {"@value":"y","@language":"de-AT"}]})",
       "e:a e:p 'x'^^e:D, 'y'@de-at ."},
      {"@value null is nothing", R"({"@id":"http://e/a","http://e/p":{"@value":null}})", ""},
      {"loose values are nothing", R"([ "x", {"@value":"y"}, {"@id":"http://e/a"}, 3 ])", ""},
      {"directions are ignored",
       R"({"@id":"http://e/a","http://e/p":{"@value":"x","@direction":"rtl"}})", "e:a e:p 'x' ."},
  });
}

TEST(JsonLdReader, ContextsGiveNamesTheirMeaning) {
  ExpectCases({
      {"a term", R"({"@context":{"p":"http://e/p"},"@id":"http://e/a","p":"x"})", "e:a e:p 'x' ."},
      {"a compact IRI", R"({"@context":{"e":"http://e/"},"@id":"e:a","e:p":{"@id":"e:b"}})",
       "e:a e:p e:b ."},
      {"no prefix without a delimiter at its end",
       R"({"@context":{"e":"http://e"},"@id":"http://e/a","http://e/p":{"@id":"e:b"}})",
       "e:a e:p <e:b> ."},
      {"unless @prefix says so",
       R"({"@context":{"n":{"@id":"http://e/n","@prefix":true}},"@id":"http://e/a",
           "http://e/p":{"@id":"n:b"}})",
       "e:a e:p e:nb ."},
      {"// after a colon is no prefix",
       R"({"@context":{"http":"http://e/"},"@id":"http://f/a","http:p":1})",
       "<http://f/a> e:p 1 ."},
      {"@vocab", R"({"@context":{"@vocab":"http://e/"},"@id":"http://e/a","p":"x","@type":"T"})",
       "e:a e:p 'x' ; a e:T ."},
      {"@vocab relative to the base", R"({"@context":{"@vocab":"v#"},"@id":"http://e/a","p":"x"})",
       "e:a <http://base/dir/v#p> 'x' ."},
      {"@base", R"({"@context":{"@base":"http://e/x/"},"@id":"../a","http://e/p":{"@id":""}})",
       "e:a e:p <http://e/x/> ."},
      {"the document's base", R"({"@id":"a","http://e/p":{"@id":"#b"}})",
       "<http://base/dir/a> e:p <http://base/dir/doc#b> ."},
      {"@type @id and @vocab",
       R"({"@context":{"@vocab":"http://e/","p":{"@type":"@id"},"q":{"@type":"@vocab"}},
           "@id":"a","p":"b","q":"b"})",
       "<http://base/dir/a> e:p <http://base/dir/b> ; e:q e:b ."},
      {"a datatype", R"({"@context":{"xsd":"http://www.w3.org/2001/XMLSchema#",
           "p":{"@id":"http://e/p","@type":"xsd:date"}},"@id":"http://e/a","p":"2020-01-01"})",
       "e:a e:p '2020-01-01'^^xsd:date ."},
      {"terms defined by later terms",
       R"({"@context":{"a":"z:a","z":"http://e/"},"@id":"http://e/x","a":1})", "e:x e:a 1 ."},
      {"aliases of keywords",
       R"({"@context":{"id":"@id","kind":"@type","p":"http://e/p","val":"@value"},
           "id":"http://e/a","kind":"http://e/T","p":{"val":"x"}})",
       "e:a a e:T ; e:p 'x' ."},
      {"a term that is null means nothing",
       R"({"@context":{"@vocab":"http://e/","p":null},"@id":"http://e/a","p":1,"q":2})",
       "e:a e:q 2 ."},
      {"the default language",
       R"({"@context":{"@language":"en","p":"http://e/p","q":{"@id":"http://e/q","@language":null},
           "r":{"@id":"http://e/r","@language":"de"}},"@id":"http://e/a","p":"x","q":"y","r":"z"})",
       "e:a e:p 'x'@en ; e:q 'y' ; e:r 'z'@de ."},
      {"several contexts, the last one wins",
       R"({"@context":[{"p":"http://e/p"},{"p":"http://e/q"}],"@id":"http://e/a","p":1})",
       "e:a e:q 1 ."},
      {"null forgets what was",
       R"({"@context":[{"p":"http://e/p"},null],"@id":"http://e/a","p":1,"http://e/q":2})",
       "e:a e:q 2 ."},
      {"contexts inside reach down",
       R"({"@context":{"@vocab":"http://e/"},"@id":"http://e/a","p":{"@context":{"@vocab":"http://f/"},
           "@id":"http://e/b","q":{"r":1}}})",
       "e:a e:p e:b . e:b <http://f/q> [ <http://f/r> 1 ] ."},
      {"names like keywords are ignored",
       R"({"@context":{"@vocab":"http://e/","@foo":"http://e/foo"},"@id":"http://e/a","@foo":1,"p":2})",
       "e:a e:p 2 ."},
      {"@version", R"({"@context":{"@version":1.1,"p":"http://e/p"},"@id":"http://e/a","p":1})",
       "e:a e:p 1 ."},
  });
}

TEST(JsonLdReader, Containers) {
  ExpectCases({
      {"@list", R"({"@id":"http://e/a","http://e/p":{"@list":[1,"x"]}})", "e:a e:p (1 'x') ."},
      {"an empty list", R"({"@id":"http://e/a","http://e/p":{"@list":[]}})", "e:a e:p () ."},
      {"a list container",
       R"({"@context":{"p":{"@id":"http://e/p","@container":"@list"}},"@id":"http://e/a","p":[1,2]})",
       "e:a e:p (1 2) ."},
      {"lists of lists",
       R"({"@context":{"p":{"@id":"http://e/p","@container":"@list"}},"@id":"http://e/a",
           "p":[[1,[2]],[],3]})",
       "e:a e:p ((1 (2)) () 3) ."},
      {"@set", R"({"@id":"http://e/a","http://e/p":{"@set":[1,{"@set":[2]}]}})", "e:a e:p 1, 2 ."},
      {"a language map",
       R"({"@context":{"p":{"@id":"http://e/p","@container":"@language"}},"@id":"http://e/a",
           "p":{"en":"x","de":["y",null,"z"],"@none":"w"}})",
       "e:a e:p 'x'@en, 'y'@de, 'z'@de, 'w' ."},
      {"an index map",
       R"({"@context":{"p":{"@id":"http://e/p","@container":"@index"}},"@id":"http://e/a",
           "p":{"one":1,"more":[2,{"@id":"http://e/b"}]}})",
       "e:a e:p 1, 2, e:b ."},
      {"an index that is a property",
       R"({"@context":{"@vocab":"http://e/","p":{"@container":"@index","@index":"key"}},
           "@id":"http://e/a","p":{"one":{"@id":"http://e/b"}}})",
       "e:a e:p e:b . e:b e:key 'one' ."},
      {"an id map",
       R"({"@context":{"@vocab":"http://e/","p":{"@container":"@id"}},"@id":"http://e/a",
           "p":{"http://e/b":{"q":1},"@none":{"q":2}}})",
       "e:a e:p e:b, [ e:q 2 ] . e:b e:q 1 ."},
      {"a type map",
       R"({"@context":{"@vocab":"http://e/","p":{"@container":"@type"}},"@id":"http://e/a",
           "p":{"T":{"@id":"http://e/b"},"U":"http://e/c"}})",
       "e:a e:p e:b, e:c . e:b a e:T . e:c a e:U ."},
      {"a named graph",
       R"({"@id":"http://e/g","http://e/p":1,"@graph":[{"@id":"http://e/a","http://e/q":2}]})",
       "e:g e:p 1 . e:g { e:a e:q 2 }"},
      {"the graph of a document is the default graph",
       R"({"@context":{"@vocab":"http://e/"},"@graph":[{"@id":"http://e/a","p":1}]})",
       "e:a e:p 1 ."},
      {"a graph container",
       R"({"@context":{"@vocab":"http://e/","p":{"@container":"@graph"}},"@id":"http://e/a",
           "p":{"@id":"http://e/b","q":1}})",
       "e:a e:p _:g . _:g { e:b e:q 1 }"},
      {"a map of graphs by id",
       R"({"@context":{"@vocab":"http://e/","p":{"@container":["@graph","@id"]}},"@id":"http://e/a",
           "p":{"http://e/g":{"@id":"http://e/b","q":1}}})",
       "e:a e:p e:g . e:g { e:b e:q 1 }"},
      {"@included",
       R"({"@id":"http://e/a","http://e/p":1,"@included":[{"@id":"http://e/b","http://e/q":2}]})",
       "e:a e:p 1 . e:b e:q 2 ."},
  });
}

TEST(JsonLdReader, ReverseNestJsonAndScopedContexts) {
  ExpectCases({
      {"@reverse", R"({"@id":"http://e/a","@reverse":{"http://e/p":{"@id":"http://e/b"}}})",
       "e:b e:p e:a ."},
      {"a reverse term",
       R"({"@context":{"of":{"@reverse":"http://e/p"}},"@id":"http://e/a",
           "of":[{"@id":"http://e/b"},{"@id":"http://e/c"}]})",
       "e:b e:p e:a . e:c e:p e:a ."},
      {"a reverse term inside @reverse is forward",
       R"({"@context":{"of":{"@reverse":"http://e/p"}},"@id":"http://e/a",
           "@reverse":{"of":{"@id":"http://e/b"}}})",
       "e:a e:p e:b ."},
      {"@nest",
       R"({"@context":{"@vocab":"http://e/","more":"@nest"},"@id":"http://e/a",
           "more":[{"p":1},{"q":2,"@nest":{"r":3}}]})",
       "e:a e:p 1 ; e:q 2 ; e:r 3 ."},
      {"@json",
       R"({"@context":{"p":{"@id":"http://e/p","@type":"@json"}},"@id":"http://e/a",
           "p":{"b":[1.0,null,1e-7],"a":"ä\n"}})",
       R"(e:a e:p '{"a":"ä\\n","b":[1,null,1e-7]}'^^rdf:JSON .)"},
      {"@json in a value", R"({"@id":"http://e/a","http://e/p":{"@type":"@json","@value":[ ]}})",
       "e:a e:p '[]'^^rdf:JSON ."},
      {"a property's own context",
       R"({"@context":{"@vocab":"http://e/","p":{"@context":{"@vocab":"http://f/"}}},
           "@id":"http://e/a","p":{"@id":"http://e/b","q":1},"q":2})",
       "e:a e:p e:b ; e:q 2 . e:b <http://f/q> 1 ."},
      {"a type's own context ends with the node",
       R"({"@context":{"@vocab":"http://e/","T":{"@context":{"@vocab":"http://f/"}}},
           "@id":"http://e/a","@type":"T","q":{"@id":"http://e/b","r":1}})",
       "e:a a e:T ; <http://f/q> e:b . e:b e:r 1 ."},
      {"unless it propagates",
       R"({"@context":{"@vocab":"http://e/","T":{"@context":{"@propagate":true,"@vocab":"http://f/"}}},
           "@id":"http://e/a","@type":"T","q":{"@id":"http://e/b","r":1}})",
       "e:a a e:T ; <http://f/q> e:b . e:b <http://f/r> 1 ."},
      {"a context that does not propagate",
       R"({"@context":{"@vocab":"http://e/"},"@id":"http://e/a",
           "p":{"@context":{"@propagate":false,"q":"http://f/q"},"@id":"http://e/b",
                "q":{"@id":"http://e/c","q":1}}})",
       "e:a e:p e:b . e:b <http://f/q> e:c . e:c e:q 1 ."},
      {"a protected term, said again in the same words",
       R"({"@context":[{"@protected":true,"p":"http://e/p"},{"p":"http://e/p"}],
           "@id":"http://e/a","p":1})",
       "e:a e:p 1 ."},
      {"a property's context may replace protected terms",
       R"({"@context":{"@protected":true,"p":"http://e/p","q":{"@id":"http://e/q",
           "@context":{"p":"http://f/p"}}},"@id":"http://e/a","q":{"@id":"http://e/b","p":1}})",
       "e:a e:q e:b . e:b <http://f/p> 1 ."},
  });
}

TEST(JsonLdReader, WhatHasNoMeaningIsLeftOutAndTold) {
  const Document document = JsonLd("{\"@id\": \"http://e/a\",\n  \"p\": 1,\n  \"http://e/q\": 2}");
  EXPECT_EQ(document.statements.size(), 1u);
  ASSERT_EQ(document.remarks.size(), 1u);
  EXPECT_EQ(document.remarks[0].place.line, 2);
  EXPECT_EQ(document.remarks[0].place.column, 3);
  EXPECT_THAT(document.remarks[0].message, HasSubstr("'p' no meaning"));
}

struct Fault {
  const char* json;
  const char* message;
};

TEST(JsonLdReader, FaultsNameTheirPlace) {
  const Fault faults[] = {
      {"{\"@context\": \"http://schema.org/\"}", "x:1:14: the context 'http://schema.org/' would"},
      {"{\"@context\": {\n \"@import\": \"http://e/c\"}}", "x:2:13: @import 'http://e/c' would"},
      {"{\"http://e/p\": [{\"@context\": [{}, \"c\"]}]}", "x:1:35: the context 'c' would"},
      {"{\"a\": 1,\n  \"a\": 2}", "x:2:3: the key 'a' is there twice"},
      {"{\"a\": 1,}", "x:1:9: this is no JSON"},
      {"", "x:1:1: this is no JSON"},
      {"{\"a\": 1e999}", "no JSON"},
      {"3", "x:1:1: a JSON-LD document is"},
      {"{\"@id\": 3}", "x:1:9: @id is a text (invalid @id value)"},
      {"{\"@type\": {\"a\": 1}}", "invalid type value"},
      {"{\"@context\": 3}", "invalid local context"},
      {"{\"@context\": {\"@base\": 3}}", "invalid base IRI"},
      {"{\"@context\": {\"@vocab\": 3}}", "invalid vocab mapping"},
      {"{\"@context\": {\"@language\": 3}}", "invalid default language"},
      {"{\"@context\": {\"@version\": 1.0}}", "invalid @version value"},
      {"{\"@context\": {\"a\": \"b:c\", \"b\": \"a:c\"}}", "cyclic IRI mapping"},
      {"{\"@context\": {\"a\": 3}}", "invalid term definition"},
      {"{\"@context\": {\"a\": {\"@id\": \"http://e/\", \"b\": 1}}}", "invalid term definition"},
      {"{\"@context\": {\"a\": {}}}", "invalid IRI mapping"},
      {"{\"@context\": {\"a\": {\"@id\": 3}}}", "invalid IRI mapping"},
      {"{\"@context\": {\"a\": \"@context\"}}", "invalid keyword alias"},
      {"{\"@context\": {\"@id\": \"http://e/\"}}", "keyword redefinition"},
      {"{\"@context\": {\"a\": {\"@id\": \"http://e/\", \"@type\": \"b\"}}}",
       "invalid type mapping"},
      {"{\"@context\": {\"a\": {\"@id\": \"http://e/\", \"@container\": [\"@list\", \"@set\"]}}}",
       "invalid container mapping"},
      {"{\"@context\": {\"a\": {\"@reverse\": \"http://e/\", \"@id\": \"http://e/\"}}}",
       "invalid reverse property"},
      {"{\"@context\": [{\"@protected\": true, \"a\": \"http://e/a\"}, {\"a\": \"http://e/b\"}]}",
       "x:1:62: the term 'a' is protected"},
      {"{\"@context\": [{\"@protected\": true, \"a\": \"http://e/a\"}, null]}",
       "invalid context nullification"},
      {"{\"@context\": {\"i\": \"@id\"}, \"@id\": \"http://e/a\", \"i\": \"http://e/b\"}",
       "colliding keywords"},
      {"{\"http://e/p\": {\"@value\": [1]}}", "invalid value object value"},
      {"{\"http://e/p\": {\"@value\": \"x\", \"http://e/q\": 1}}", "invalid value object"},
      {"{\"http://e/p\": {\"@value\": 1, \"@language\": \"en\"}}", "invalid language-tagged value"},
      {"{\"http://e/p\": {\"@value\": 1, \"@type\": \"_:b\"}}", "invalid typed value"},
      {"{\"http://e/p\": {\"@list\": [1], \"@id\": \"http://e/a\"}}", "invalid set or list object"},
      {"{\"@reverse\": {\"http://e/p\": \"x\"}}", "invalid reverse property value"},
      {"{\"@reverse\": 3}", "invalid @reverse value"},
      {"{\"@included\": \"x\"}", "invalid @included value"},
      {"{\"@nest\": {\"@value\": 1}}", "invalid @nest value"},
      {"{\"http://e/p\": \"\xFF\"}", "not UTF-8"},
      {"{\"http://e/p\": \"\\ud800\"}", "no JSON"},
      {"{\"http://e/p\": {\"@value\": \"x\", \"@language\": \"no tag\"}}", "is not a language tag"},
  };
  for (const Fault& fault : faults) {
    const Error error = FaultOf(fault.json, Format::kJsonLd, Based());
    EXPECT_THAT(error.FullMessage(), HasSubstr(fault.message)) << fault.json;
    EXPECT_EQ(error.code(), Code::kInvalid) << fault.json;
    ASSERT_TRUE(error.place()) << fault.json;
    EXPECT_GT(error.place()->line, 0) << fault.json;
  }
}

TEST(JsonLdReader, RelativeIriWithoutBaseIsAnError) {
  const Error error = FaultOf("{\"@id\": \"a\", \"http://e/p\": 1}", Format::kJsonLd, Named("x"));
  EXPECT_THAT(error.FullMessage(), HasSubstr("relative"));
}

TEST(JsonLdReader, DepthSizeAndCountHaveLimits) {
  const std::string deep = std::string(300, '[') + std::string(300, ']');
  EXPECT_EQ(FaultOf(deep, Format::kJsonLd, Based()).code(), Code::kTooLarge);
  ReadOptions options = Based();
  options.max_statements = 2;
  EXPECT_EQ(FaultOf(R"({"@id":"a","http://e/p":[1,2,3]})", Format::kJsonLd, options).code(),
            Code::kTooLarge);
  options = Based();
  options.max_bytes = 3;
  EXPECT_EQ(FaultOf("{  }", Format::kJsonLd, options).code(), Code::kTooLarge);
}

TEST(JsonLdReader, ContextsThatCopyEachOtherWithoutEndAreRefused) {
  std::string text = "{\"@context\": [{";
  for (int i = 0; i < 3000; ++i) text += "\"t" + std::to_string(i) + "\": \"http://e/t\", ";
  text += "\"t\": \"http://e/t\"}";
  for (int i = 0; i < 4000; ++i) text += ", {\"u" + std::to_string(i) + "\": \"http://e/u\"}";
  text += "]}";
  const Error error = FaultOf(text, Format::kJsonLd, Based());
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_TRUE(error.place());
}

TEST(JsonLdWriter, WrittenAndReadAgainIsTheSame) {
  const char* documents[] = {
      "e:a a e:T, [ a e:U ] ; e:p 'x', 'y'@en, 1, '01'^^xsd:integer, true, 'z'^^e:D, e:b .",
      "e:a e:p (1 (2 e:b) () [ e:q 'x' ]) ; e:q () . [] e:p 1 .",
      "e:g { e:a e:p _:b . _:b e:q 1 } e:g e:p 2 . _:h { e:a e:p (1) } _:h e:p 3 .",
      "_:a e:p _:b . _:b e:p _:a . _:c rdf:first 1 ; rdf:rest _:c . e:a a (1), 'literal' .",
      "_:a e:p _:l . e:b e:p _:l . _:l rdf:first 1 ; rdf:rest () .",
      R"(e:a e:p '{"a":[1,true,null]}'^^rdf:JSON, '{ "a" : 1 }'^^rdf:JSON, 'no json'^^rdf:JSON .)",
      "<urn:a> e:p <e:b>, <http:c>, <mailto:x@y> . e:a <urn:p> '\\u0001\"\\\\ä' .",
      "e:a e:p 123456789012345678901234567890, -0.5e0, '2020-01-01'^^xsd:date .",
  };
  for (const char* text : documents) {
    const Document document = ReadRdf(kPrefixes + std::string(text), Format::kTriG, Based());
    const std::string json = WriteRdf(document, Format::kJsonLd);
    const Document again = ReadRdf(json, Format::kJsonLd, Based());
    EXPECT_TRUE(AreIsomorphic(document, again)) << text << "\n" << json << Lines(again);
    EXPECT_TRUE(again.remarks.empty()) << json;
  }
}

TEST(JsonLdWriter, UsesPrefixesListsAndInlineNodes) {
  const Document document =
      ReadRdf("@prefix e: <http://e/> . e:a a e:T ; e:p (1 'x') ; e:q [ e:r e:b ] .",
              Format::kTurtle, Named("x"));
  EXPECT_EQ(WriteRdf(document, Format::kJsonLd), R"({
 "@context": {
  "e": "http://e/"
 },
 "@graph": [
  {
   "@id": "e:a",
   "@type": "e:T",
   "e:p": {
    "@list": [
     1,
     "x"
    ]
   },
   "e:q": {
    "e:r": {
     "@id": "e:b"
    }
   }
  }
 ]
}
)");
}

TEST(JsonLdWriter, WhatIsNestedTooDeepToReadIsWrittenFlat) {
  std::string text = "@prefix e: <http://e/> . e:a e:p ";
  for (int i = 0; i < 200; ++i) text += i % 2 == 0 ? "[ e:p " : "( ";
  text += "1";
  for (int i = 200; i-- > 0;) text += i % 2 == 0 ? " ]" : " )";
  const Document document = ReadRdf(text + " .", Format::kTurtle, Named("x"));
  const Document again = ReadRdf(WriteRdf(document, Format::kJsonLd), Format::kJsonLd, Named("x"));
  EXPECT_TRUE(AreIsomorphic(document, again));
}

}  // namespace
}  // namespace lares::rdf
