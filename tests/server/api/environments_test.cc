#include <gmock/gmock.h>

#include <fstream>

#include "base/hash.h"
#include "mapping/environment/tar_reader.h"
#include "server/api/tar.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class EnvironmentsTest : public ApiTest {
 protected:
  http::ClientResponse Put(const std::vector<http::FormPart>& parts, const std::string& header = "",
                           const std::string& value = "") {
    return SendForm("POST", "/v1/environments/lab/versions", parts, header, value);
  }
  static http::FormPart Semantic(const std::string& text = kTurtle) {
    return {"semantic", text, {}, "room.ttl", "text/turtle"};
  }
  static http::FormPart Trajectory() {
    return {"trajectory", kTrajectory, {}, "path.txt", "text/plain"};
  }
};

TEST_F(EnvironmentsTest, VersionsAreAddedListedAndRead) {
  const auto first = Put({Semantic(),
                          {"type", "HospitalRoom", {}, "", ""},
                          {"label", "Room 1", {}, "", ""},
                          {"note", "first", {}, "", ""}});
  ASSERT_EQ(first.status, 201) << first.body;
  EXPECT_EQ(first.headers.Get("Location"), "/v1/environments/lab/versions/1");
  EXPECT_EQ(Json(first)["warnings"][0]["message"], "a warning");
  ASSERT_EQ(Put({Trajectory(), {"author", "me", {}, "", ""}}).status, 201);

  const auto environment = Json(Get("/v1/environments/lab"));
  EXPECT_EQ(environment["type"], "https://w3id.org/lares#HospitalRoom");
  EXPECT_EQ(environment["label"], "Room 1");
  EXPECT_EQ(environment["latest"], 2);
  EXPECT_EQ(environment["version"]["layers"].size(), 2u);
  EXPECT_EQ(environment["version"]["changed_layers"], nlohmann::json({"trajectory"}));
  const auto log = Json(Get("/v1/environments/lab/versions"));
  EXPECT_EQ(log["items"][0]["number"], 2);
  EXPECT_EQ(log["items"][1]["note"], "first");
  EXPECT_EQ(Json(Get("/v1/environments"))["items"][0]["id"], "lab");
  EXPECT_EQ(Json(Get("/v1/environments/lab/versions/1"))["layers"].size(), 1u);
  EXPECT_EQ(Json(Get("/v1/environments/lab/versions/latest"))["number"], 2);
  EXPECT_EQ(Json(Get("/v1/environments/lab/versions/1/objects"))["items"][0]["pose"]["position_m"],
            nlohmann::json({1, 2, 3}));
}

TEST_F(EnvironmentsTest, LayersAreGivenAsReceivedWithRangesAndTags) {
  Put({Semantic(), Trajectory()});
  const std::string path = "/v1/environments/lab/versions/1/layers/trajectory";
  const auto whole = Get(path);
  EXPECT_EQ(whole.body, kTrajectory);
  const std::string etag(whole.headers.Get("ETag"));
  EXPECT_EQ(Get(path, "If-None-Match", etag).status, 304);
  const auto part = Get(path, "Range", "bytes=4-6");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, std::string(kTrajectory).substr(4, 3));
  EXPECT_EQ(Get(path, "Range", "bytes=100000-").status, 416);
  EXPECT_EQ(client_->Send({"HEAD", path, {}, {}, {}}).headers.Get("Content-Length"),
            std::to_string(std::string(kTrajectory).size()));
}

TEST_F(EnvironmentsTest, TheSemanticLayerIsRenderedAsAccepted) {
  Put({Semantic()});
  const std::string path = "/v1/environments/lab/versions/latest/layers/semantic";
  EXPECT_EQ(Get(path).body, kTurtle);
  EXPECT_EQ(Get(path, "Accept", "text/turtle").body, kTurtle);
  const auto xml = Get(path, "Accept", "application/rdf+xml");
  EXPECT_EQ(xml.body, "lab/1 as application/rdf+xml");
  EXPECT_EQ(xml.headers.Get("Content-Type"), "application/rdf+xml");
  EXPECT_NE(xml.headers.Get("ETag"), Get(path).headers.Get("ETag"));
  EXPECT_EQ(Get(path, "Accept", "application/owl+xml").body, "lab/1 as application/owl+xml");
  const auto functional = Get(path, "Accept", "text/owl-functional");
  EXPECT_EQ(functional.headers.Get("Content-Type"), "text/owl-functional");
  EXPECT_NE(functional.headers.Get("Content-Disposition").find("semantic.ofn"),
            std::string_view::npos);
  for (const auto& [type, extension] :
       {std::pair("application/trig", ".trig"), std::pair("application/n-triples", ".nt"),
        std::pair("application/n-quads", ".nq"), std::pair("application/ld+json", ".jsonld")}) {
    const auto other = Get(path, "Accept", type);
    EXPECT_EQ(other.body, std::string("lab/1 as ") + type);
    EXPECT_EQ(other.headers.Get("Content-Type"), type);
    EXPECT_NE(other.headers.Get("Content-Disposition").find(extension), std::string_view::npos);
  }
  EXPECT_EQ(Get(path, "Accept", "image/png").status, 406);
}

TEST_F(EnvironmentsTest, OneTarHoldsAVersion) {
  Put({Semantic(), Trajectory()});
  const auto tar = Get("/v1/environments/lab/versions/1.tar");
  ASSERT_EQ(tar.status, 200);
  EXPECT_EQ(std::string(tar.headers.Get("Content-Length")), std::to_string(tar.body.size()));
  auto reader = environment::TarReader::OfBytes(tar.body, "lab.tar");
  std::vector<std::string> names;
  std::string manifest;
  while (const auto entry = reader.Next()) {
    names.push_back(entry->path);
    std::string content(entry->size, '\0');
    EXPECT_EQ(reader.Read(content.data(), content.size()), entry->size);
    if (entry->path == "manifest.json") manifest = content;
    if (entry->path == "semantic.ttl") {
      EXPECT_EQ(content, kTurtle);
    }
  }
  EXPECT_THAT(names, ElementsAre("manifest.json", "semantic.ttl", "trajectory.txt"));
  const auto json = nlohmann::json::parse(manifest);
  EXPECT_EQ(json["layers"][0]["file"], "semantic.ttl");
  EXPECT_EQ(json["layers"][0]["sha256"], Sha256Hex(kTurtle));
}

TEST_F(EnvironmentsTest, TarOfAVersionStaysTheSameWhenALaterOneChangesTheLabel) {
  Put({Semantic(), {"label", "old", {}, "", ""}});
  const auto before = Get("/v1/environments/lab/versions/1.tar");
  Put({Semantic("<urn:x> <urn:y> <urn:z> .\n"), {"label", "new", {}, "", ""}});
  const auto after = Get("/v1/environments/lab/versions/1.tar");
  EXPECT_EQ(after.headers.Get("ETag"), before.headers.Get("ETag"));
  EXPECT_EQ(after.body, before.body);
  EXPECT_EQ(Json(Get("/v1/environments/lab/versions/1"))["label"], "old");
  EXPECT_EQ(Json(Get("/v1/environments/lab/versions/2"))["label"], "new");
}

TEST_F(EnvironmentsTest, AnEmptyFormAddsNoVersion) {
  Put({Semantic()});
  const auto refused = Put({});
  EXPECT_EQ(refused.status, 422) << refused.body;
  EXPECT_THAT(Json(refused)["detail"].get<std::string>(), HasSubstr("nothing to put"));
  EXPECT_EQ(Json(Get("/v1/environments/lab"))["latest"], 1);
}

TEST_F(EnvironmentsTest, TwoClientsCannotBothReplaceTheSameVersion) {
  const auto first = Put({Semantic()}, "If-None-Match", "*");
  ASSERT_EQ(first.status, 201);
  const std::string etag(first.headers.Get("ETag"));
  EXPECT_EQ(Put({Semantic("<urn:x> <urn:y> <urn:z> .\n")}, "If-Match", etag).status, 201);
  const auto second = Put({Semantic("<urn:q> <urn:y> <urn:z> .\n")}, "If-Match", etag);
  EXPECT_EQ(second.status, 412);
  EXPECT_THAT(Json(second)["detail"].get<std::string>(), HasSubstr("\"lab-2\""));
  EXPECT_EQ(Put({Semantic()}, "If-None-Match", "*").status, 412);
  EXPECT_EQ(Json(Get("/v1/environments/lab"))["latest"], 2);
}

TEST_F(EnvironmentsTest, ALayerThatIsNotWhatItClaimsLeavesNothing) {
  const auto refused = Put({Semantic(), {"octomap", "this is no octree", {}, "map.bt", ""}});
  EXPECT_EQ(refused.status, 422) << refused.body;
  EXPECT_EQ(Json(refused)["place"]["source"], "map.bt");
  EXPECT_EQ(Get("/v1/environments/lab").status, 404);
}

TEST_F(EnvironmentsTest, FormsThatMakeNoSenseAreRefused) {
  const auto unknown = Put({{"octomop", "x", {}, "a.bt", ""}});
  EXPECT_EQ(unknown.status, 422);
  EXPECT_EQ(Json(unknown)["candidates"][0], "octomap");
  EXPECT_EQ(Put({Semantic(), Semantic()}).status, 422);
  EXPECT_EQ(Put({{"label", "only words", {}, "", ""}}).status, 422);
  EXPECT_EQ(Put({Semantic(), {"type", "Nonsense", {}, "", ""}}).status, 404);
  EXPECT_EQ(Put({{"note", std::string(100'000, 'x'), {}, "", ""}}).status, 413);
  EXPECT_EQ(Send("POST", "/v1/environments/lab/versions", "text/turtle", kTurtle).status, 415);
  EXPECT_EQ(SendForm("POST", "/v1/environments/.x/versions", {Semantic()}).status, 422);
  EXPECT_TRUE(Json(Get("/v1/environments"))["items"].empty());
}

TEST_F(EnvironmentsTest, ALayerCanBeLeftOutOfTheNextVersion) {
  Put({Semantic(), Trajectory()});
  const auto next = Put({{"remove", "trajectory", {}, "", ""}});
  ASSERT_EQ(next.status, 201) << next.body;
  EXPECT_EQ(Json(next)["version"]["layers"].size(), 1u);
  EXPECT_EQ(Get("/v1/environments/lab/versions/2/layers/trajectory").status, 404);
  EXPECT_EQ(Get("/v1/environments/lab/versions/1/layers/trajectory").status, 200);
}

TEST_F(EnvironmentsTest, NamesThatLeadNowhereAreNotFound) {
  Put({Semantic()});
  for (const char* path :
       {"/v1/environments/nowhere", "/v1/environments/lab/versions/2",
        "/v1/environments/lab/versions/1/layers/cloud", "/v1/environments/nowhere/versions"}) {
    EXPECT_EQ(Get(path).status, 404) << path;
  }
  for (const char* number : {"0", "-1", "1x"}) {
    EXPECT_EQ(Get(std::string("/v1/environments/lab/versions/") + number).status, 422) << number;
  }
  for (const char* tag : {"one", "99999999999"}) {
    EXPECT_EQ(Get(std::string("/v1/environments/lab/versions/") + tag).status, 404) << tag;
  }
}

TEST_F(EnvironmentsTest, AnInterruptedUploadIsInvisible) {
  http::EncodedForm form = http::EncodeForm({Semantic()});
  form.pieces.pop_back();  // the closing boundary never comes
  form.length -= 1;
  form.length = 0;
  for (const auto& piece : form.pieces) form.length += piece.length;
  EXPECT_EQ(client_->Send({"POST", "/v1/environments/lab/versions", {}, {}, form}).status, 400);
  EXPECT_EQ(Get("/v1/environments/lab").status, 404);
}

TEST(TarTest, WritesWhatAnyReaderReads) {
  const std::string big = api::TarHeader("big", std::uint64_t{1} << 40, Time{});
  EXPECT_EQ(big.size(), 512u);
  EXPECT_EQ(static_cast<unsigned char>(big[124]), 0x80);  // base-256
  EXPECT_EQ(big[124 + 6], 1);                             // 2^40 in its fifth byte from the right
  EXPECT_THROW(api::TarHeader(std::string(101, 'x'), 0, Time{}), Error);
  EXPECT_EQ(api::TarPadding(512), "");
  EXPECT_EQ(api::TarPadding(1).size(), 511u);
  EXPECT_EQ(api::TarEntrySize(513), 512u + 1024u);
}

}  // namespace
}  // namespace lares::testing
