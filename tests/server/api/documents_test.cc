#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(ApiTest, ARecipeIsStoredListedReadAndRemoved) {
  const auto put = Send("PUT", "/v1/recipes/search?file_name=search.ttl", "text/turtle", kTurtle);
  ASSERT_EQ(put.status, 201) << put.body;
  EXPECT_EQ(put.headers.Get("Location"), "/v1/recipes/search");
  const auto answer = Json(put);
  EXPECT_EQ(answer["document"]["id"], "search");
  EXPECT_EQ(answer["document"]["version"], 1);
  EXPECT_EQ(answer["tasks"][0]["label"], "FindBottle");
  EXPECT_EQ(answer["tasks"][0]["form"], "state-machine");
  EXPECT_EQ(answer["warnings"][0]["message"], "'urn:absent' is not in the catalogue");

  const auto listed = Json(Get("/v1/recipes"))["items"][0];
  EXPECT_EQ(listed["id"], "search");
  EXPECT_EQ(listed["names"][0]["text"], "Label of search");
  EXPECT_FALSE(listed.contains("details"));
  const auto got = Get("/v1/recipes/search");
  EXPECT_EQ(got.body, kTurtle);
  EXPECT_EQ(got.headers.Get("Content-Type"), "text/turtle");
  EXPECT_EQ(got.headers.Get("ETag"), put.headers.Get("ETag"));
  EXPECT_THAT(std::string(got.headers.Get("Content-Disposition")), HasSubstr("\"search.ttl\""));
  EXPECT_EQ(Json(Get("/v1/recipes/search?as=info"))["sha256"], answer["document"]["sha256"]);

  EXPECT_EQ(Send("DELETE", "/v1/recipes/search", "", "").status, 204);
  EXPECT_EQ(Get("/v1/recipes/search").status, 404);
  EXPECT_EQ(Json(Get("/v1/recipes"))["count"], 0);
}

TEST_F(ApiTest, OlderVersionsStayReadable) {
  Send("PUT", "/v1/robots/r", "text/turtle", "one");
  EXPECT_EQ(Send("PUT", "/v1/robots/r", "text/turtle", "two").status, 200);
  EXPECT_EQ(Get("/v1/robots/r").body, "two");
  EXPECT_EQ(Get("/v1/robots/r?version=1").body, "one");
  const auto log = Json(Get("/v1/robots/r/versions"));
  ASSERT_EQ(log["items"].size(), 2u);
  EXPECT_EQ(log["items"][0]["version"], 2);
  EXPECT_EQ(Get("/v1/robots/r?version=3").status, 404);
  EXPECT_EQ(Get("/v1/robots/nobody/versions").status, 404);
}

TEST_F(ApiTest, PutOfTheSameBytesCreatesNothing) {
  EXPECT_EQ(Send("PUT", "/v1/robots/r", "text/turtle", "one").status, 201);
  EXPECT_EQ(Send("PUT", "/v1/robots/r", "text/turtle", "one").status, 200);
}

TEST_F(ApiTest, AWriteBoundToAnETagIsRefusedOnceItIsOld) {
  const auto first = Send("PUT", "/v1/recipes/a", "text/turtle", "one", "If-None-Match", "*");
  ASSERT_EQ(first.status, 201);
  EXPECT_EQ(Send("PUT", "/v1/recipes/a", "text/turtle", "two", "If-None-Match", "*").status, 412);
  const std::string etag(first.headers.Get("ETag"));
  EXPECT_EQ(Send("PUT", "/v1/recipes/a", "text/turtle", "two", "If-Match", etag).status, 200);
  const auto old = Send("PUT", "/v1/recipes/a", "text/turtle", "three", "If-Match", etag);
  EXPECT_EQ(old.status, 412);
  EXPECT_EQ(Json(old)["code"], "precondition-failed");
  EXPECT_EQ(Send("DELETE", "/v1/recipes/a", "", "", "If-Match", etag).status, 412);
  EXPECT_EQ(Get("/v1/recipes/a").body, "two");
}

TEST_F(ApiTest, AMalformedDocumentIsRefusedWithItsPlaceAndNothingIsKept) {
  const auto refused = Send("PUT", "/v1/recipes/explore?file_name=exploration-recipe.owl",
                            "application/rdf+xml", "malformed");
  EXPECT_EQ(refused.status, 422);
  EXPECT_EQ(refused.headers.Get("Content-Type"), "application/problem+json");
  const auto problem = Json(refused);
  EXPECT_EQ(problem["place"]["source"], "exploration-recipe.owl");
  EXPECT_EQ(problem["place"]["line"], 715);
  EXPECT_THAT(problem["hint"].get<std::string>(), HasSubstr("--recover"));
  EXPECT_EQ(Json(Get("/v1/recipes"))["count"], 0);

  const auto recovered = Send("PUT", "/v1/recipes/explore?recover=true&file_name=e.owl",
                              "application/rdf+xml", "malformed");
  EXPECT_EQ(recovered.status, 201);
  EXPECT_EQ(Json(recovered)["repairs"][0]["place"]["line"], 715);
  EXPECT_EQ(Get("/v1/recipes/explore").body, "malformed");
}

TEST_F(ApiTest, TheIdDefaultsToTheFilesStem) {
  const auto form =
      SendForm("POST", "/v1/robots", {{"file", kTurtle, {}, "../Pioneer.3.ttl", "text/turtle"}});
  ASSERT_EQ(form.status, 201) << form.body;
  EXPECT_EQ(Json(form)["document"]["id"], "Pioneer.3");
  EXPECT_EQ(Json(Send("POST", "/v1/robots?file_name=amigo.owl", "application/rdf+xml",
                      "x"))["document"]["id"],
            "amigo");
  EXPECT_EQ(
      SendForm("POST", "/v1/robots", {{"file", "x", {}, "a.ttl", ""}, {"id", "mine", {}, "", ""}})
          .headers.Get("Location"),
      "/v1/robots/mine");
  EXPECT_EQ(Send("POST", "/v1/robots", "text/turtle", kTurtle).status, 422);
  EXPECT_EQ(Send("POST", "/v1/robots?file_name=my%20file.ttl", "text/turtle", kTurtle).status, 422);
}

TEST_F(ApiTest, BadParametersAreRefused) {
  Send("PUT", "/v1/recipes/a", "text/turtle", "one");
  for (const char* path :
       {"/v1/recipes?limit=0", "/v1/recipes?limit=x", "/v1/recipes?limit=1001",
        "/v1/recipes/a?version=0", "/v1/recipes/a?version=1.5", "/v1/recipes/a?as=picture"}) {
    EXPECT_EQ(Get(path).status, 422) << path;
  }
  EXPECT_EQ(Get("/v1/recipes?limit=%zz").status, 400);
  EXPECT_EQ(Get("/v1/recipes?after=nobody").status, 404);
  EXPECT_EQ(Send("PUT", "/v1/recipes/a?recover=perhaps", "text/turtle", "x").status, 422);
  EXPECT_EQ(Send("PUT", "/v1/recipes/a", "image/png", "x").status, 415);
  EXPECT_EQ(Send("PUT", "/v1/recipes/.hidden", "text/turtle", "x").status, 422);
}

TEST_F(ApiTest, ListsArePaged) {
  for (const char* id : {"a", "b", "c", "d", "e"}) {
    Send("PUT", std::string("/v1/recipes/") + id, "text/turtle", id);
  }
  const auto first = Json(Get("/v1/recipes?limit=2"));
  EXPECT_EQ(first["count"], 5);
  EXPECT_EQ(first["items"].size(), 2u);
  EXPECT_EQ(first["next"], "b");
  const auto last = Json(Get("/v1/recipes?limit=2&after=d"));
  EXPECT_EQ(last["items"][0]["id"], "e");
  EXPECT_TRUE(last["next"].is_null());
}

TEST_F(ApiTest, AListShowsTheNewestVersionAtOnce) {
  Send("PUT", "/v1/recipes/a", "text/turtle", "one");
  EXPECT_EQ(Json(Get("/v1/recipes"))["items"][0]["version"], 1);
  Send("PUT", "/v1/recipes/a", "text/turtle", "two");
  EXPECT_EQ(Json(Get("/v1/recipes"))["items"][0]["version"], 2);
}

TEST_F(ApiTest, AnUnknownIdBringsSimilarOnes) {
  Send("PUT", "/v1/robots/pioneer", "text/turtle", "x");
  EXPECT_EQ(Json(Get("/v1/robots/pionier"))["candidates"][0], "pioneer");
}

TEST_F(ApiTest, PriorsNameTheirFormat) {
  EXPECT_EQ(Send("PUT", "/v1/priors/omics", "text/tab-separated-values", "a\tb\t1\n").status, 422);
  std::string format;
  Answers().put = [&](const server::PutRequest& request, store::Store& store) {
    format = request.prior_format;
    server::PutAnswer answer;
    answer.document = store.PutDocument({request.kind, request.id, "text/plain", "", "x"});
    return answer;
  };
  EXPECT_EQ(Send("PUT", "/v1/priors/p?format=tsv", "text/tab-separated-values", "a\tb\t1\n").status,
            201);
  EXPECT_EQ(format, "tsv");
  EXPECT_EQ(Json(Get("/v1/priors"))["items"][0]["id"], "p");
}

TEST_F(ApiTest, OntologyModulesAliasesAndClassesAreListed) {
  EXPECT_EQ(Send("PUT", "/v1/ontology/modules/knowrob", "text/turtle", kTurtle).status, 201);
  const auto modules = Json(Get("/v1/ontology/modules"));
  EXPECT_EQ(modules["items"][0]["origin"], "built-in");
  EXPECT_EQ(modules["items"][1]["document"]["version"], 1);
  EXPECT_EQ(Json(Get("/v1/ontology/aliases"))["items"][0]["namespace"], true);
  EXPECT_EQ(Json(Get("/v1/ontology/classes/Cup"))["iri"], "https://w3id.org/lares#Cup");
  const auto missing = Get("/v1/ontology/classes/Nonsense");
  EXPECT_EQ(missing.status, 404);
  EXPECT_EQ(Json(missing)["candidates"][0], "Nonce");
}

TEST_F(ApiTest, SkillTemplatesAreListedAndTheirDocumentsKept) {
  const auto list = Json(Get("/v1/skill-templates"));
  EXPECT_EQ(list["items"][0]["skill"], "Wave");
  EXPECT_TRUE(list["items"][0]["document"].is_null());
  EXPECT_EQ(Send("PUT", "/v1/skill-templates/mine", "text/turtle", kTurtle).status, 201);
  EXPECT_EQ(Get("/v1/skill-templates/mine").body, kTurtle);
  EXPECT_EQ(Json(Get("/v1/skill-templates/mine/versions"))["count"], 1);
  EXPECT_EQ(Send("DELETE", "/v1/skill-templates/mine", "", "").status, 204);
  EXPECT_EQ(Get("/v1/skill-templates/mine").status, 404);
}

TEST_F(ApiTest, AnObjectModelKeepsItsFiles) {
  const auto photo = Write("face1.png", std::string("\x89PNG\0bytes", 10));
  const auto put = SendForm("PUT", "/v1/object-models/cabinet1",
                            {{"description", kTurtle, {}, "cabinet.ttl", "text/turtle"},
                             {"file", "", photo, "face1.png", "image/png"}});
  ASSERT_EQ(put.status, 201) << put.body;
  const auto list = Json(Get("/v1/object-models?class=Cabinet"));
  EXPECT_EQ(list["items"][0]["classes"][0]["label"], "Cabinet");
  EXPECT_EQ(list["items"][0]["details"]["files"][0]["file_name"], "face1.png");
  EXPECT_EQ(Json(Get("/v1/object-models?class=Bottle"))["count"], 0);
  const auto file = Get("/v1/object-models/cabinet1/files/face1.png");
  EXPECT_EQ(file.body.size(), 10u);
  EXPECT_EQ(file.headers.Get("Content-Type"), "image/png");
  EXPECT_EQ(Get("/v1/object-models/cabinet1/files/face2.png").status, 404);
  EXPECT_EQ(Get("/v1/object-models/cabinet1").body, kTurtle);
  EXPECT_EQ(SendForm("PUT", "/v1/object-models/b", {{"file", "x", {}, "a", ""}}).status, 422);
}

TEST_F(ApiTest, ObjectModelsAreShownWithWhatIsKnownOfThem) {
  ASSERT_EQ(SendForm("PUT", "/v1/object-models/cabinet1",
                     {{"description", kTurtle, {}, "cabinet.ttl", "text/turtle"}})
                .status,
            201);
  const auto item = Json(Get("/v1/object-models?class=Cabinet&room=Office&maker=Ada"))["items"][0];
  EXPECT_EQ(item["fit"], "same");
  EXPECT_EQ(item["probability"], 0.25);
  EXPECT_EQ(item["makers"][0]["label"], "Ada");
  EXPECT_EQ(item["extents"]["depth_m"], 0.6);
  EXPECT_FALSE(Json(Get("/v1/object-models"))["items"][0].contains("fit"));
}

TEST_F(ApiTest, TypicalObjectModelsAreChosenWithReasons) {
  for (const char* id : {"a", "b"}) {
    ASSERT_EQ(SendForm("PUT", std::string("/v1/object-models/") + id,
                       {{"description", kTurtle, {}, "it.ttl", "text/turtle"}})
                  .status,
              201);
  }
  const auto answer =
      Json(Get("/v1/object-models/typical?room=Office&robot=scout&strict=true&max_models=1"));
  EXPECT_EQ(answer["room"]["label"], "Office");
  EXPECT_EQ(answer["robot"]["label"], "scout");
  ASSERT_EQ(answer["loaded"].size(), 1u);
  EXPECT_EQ(answer["loaded"][0]["id"], "a");
  EXPECT_EQ(answer["loaded"][0]["probability"], 0.5);
  EXPECT_EQ(answer["loaded"][0]["files"][0]["link"], "/v1/object-models/a?version=1");
  EXPECT_EQ(Get("/v1/object-models/a?version=1").body, kTurtle);
  EXPECT_EQ(answer["left_out"][0]["verdict"], "too-many");
  EXPECT_TRUE(Json(Get("/v1/object-models/typical?room=Office"))["robot"].is_null());
  for (const char* wrong : {"", "?room=", "?room=Office&max_models=-1", "?room=Office&max_bytes=x",
                            "?room=Office&min_probability=nan", "?room=Office&min_probability=1.5",
                            "?room=Office&strict=maybe"}) {
    EXPECT_EQ(Get(std::string("/v1/object-models/typical") + wrong).status, 422) << wrong;
  }
  EXPECT_EQ(Get("/v1/object-models/typical?room=Office&robot=nobody").status, 404);
  EXPECT_EQ(SendForm("PUT", "/v1/object-models/typical",
                     {{"description", kTurtle, {}, "it.ttl", "text/turtle"}})
                .status,
            422);
}

TEST_F(ApiTest, EverySyntaxOfRdfIsAccepted) {
  for (const std::string type :
       {"application/rdf+xml", "text/turtle", "application/trig", "application/n-triples",
        "application/n-quads", "application/ld+json"}) {
    EXPECT_EQ(Send("PUT", "/v1/ontology/modules/a", type, "x" + type).status / 100, 2) << type;
  }
  EXPECT_EQ(Send("PUT", "/v1/ontology/modules/a", "application/json", "{}").status, 415);
}

TEST_F(ApiTest, AnOntologyIsCheckedAndNotKept) {
  const auto clean = Send("POST", "/v1/ontology/check?file_name=a.ttl", "text/turtle", kTurtle);
  ASSERT_EQ(clean.status, 200) << clean.body;
  EXPECT_EQ(Json(clean)["clean"], true);
  EXPECT_EQ(Json(clean)["findings"].size(), 0u);
  const auto found = Json(Send("POST", "/v1/ontology/check?file_name=a.ttl", "text/turtle", "bad"));
  EXPECT_EQ(found["clean"], false);
  EXPECT_EQ(found["owl2_rl"], false);
  EXPECT_EQ(found["findings"][0]["kind"], "profile");
  EXPECT_EQ(found["findings"][0]["count"], 7);
  EXPECT_EQ(found["findings"][0]["places"][0]["line"], 3);
  EXPECT_EQ(found["findings"][0]["places"][0]["source"], "a.ttl");
  EXPECT_EQ(found["findings"][0]["names"][1], "Mug");
  EXPECT_EQ(found["warnings"].size(), 1u);
  EXPECT_EQ(Send("POST", "/v1/ontology/check", "image/png", "x").status, 415);
  EXPECT_EQ(Json(Get("/v1/ontology/modules"))["items"].size(),
            Json(Get("/v1/ontology/modules"))["count"]);
  EXPECT_FALSE(store_->FindDocument(store::DocumentKind::kOntology, "a"));
}

TEST_F(ApiTest, AWebPageOfAnotherOriginCannotWrite) {
  EXPECT_EQ(
      Send("PUT", "/v1/recipes/a", "text/turtle", kTurtle, "Origin", "http://evil.example").status,
      403);
  EXPECT_EQ(Json(Get("/v1/recipes"))["count"], 0);
}

}  // namespace
}  // namespace lares::testing
