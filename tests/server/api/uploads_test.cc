// Resumable uploads and links by hash, over HTTP.
#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/file.h"
#include "base/hash.h"
#include "server/http/zstd.h"
#include "server/store/uploads.h"
#include "tests/server/api/api_fixture.h"
#include "tests/server/http/raw_client.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using HeaderList = std::vector<std::pair<std::string, std::string>>;

class UploadsApiTest : public ApiTest {
 protected:
  http::ClientResponse Tus(const std::string& method, const std::string& path,
                           const HeaderList& headers = {}, const std::string& body = "") {
    http::ClientRequest request{method, path, {}, {}, {}};
    request.headers.Set("Tus-Resumable", "1.0.0");
    for (const auto& [name, value] : headers) request.headers.Set(name, value);
    if (!body.empty()) {
      request.headers.Set("Content-Type", "application/offset+octet-stream");
      request.body = body;
    }
    return client_->Send(request);
  }
  std::string Create(std::size_t length, const HeaderList& more = {}) {
    HeaderList headers = more;
    headers.emplace_back("Upload-Length", std::to_string(length));
    const auto created = Tus("POST", "/v1/uploads", headers);
    EXPECT_EQ(created.status, 201) << created.body;
    return std::string(created.headers.Get("Location"));
  }
  http::ClientResponse Patch(const std::string& path, std::size_t offset, const std::string& body,
                             const HeaderList& more = {}) {
    HeaderList headers = more;
    headers.emplace_back("Upload-Offset", std::to_string(offset));
    return Tus("PATCH", path, headers, body);
  }
  std::string Offset(const std::string& path) {
    return std::string(Tus("HEAD", path).headers.Get("Upload-Offset"));
  }
  http::ClientResponse PutReference(const std::string& layer, const std::string& reference,
                                    const std::string& file_name = "") {
    return SendForm("POST", "/v1/environments/lab/versions",
                    {{layer, reference, {}, file_name, "application/vnd.lares.upload"}});
  }
};

TEST_F(UploadsApiTest, WhatThereIsIsToldBeforeAnythingIsSent) {
  const auto told = client_->Send({"OPTIONS", "/v1/uploads", {}, {}, {}});
  EXPECT_EQ(told.status, 204);
  EXPECT_EQ(told.headers.Get("Tus-Version"), "1.0.0");
  EXPECT_EQ(told.headers.Get("Tus-Extension"),
            "creation,creation-with-upload,expiration,checksum,termination");
  EXPECT_EQ(told.headers.Get("Tus-Checksum-Algorithm"), "sha256");
  EXPECT_FALSE(told.headers.Get("Tus-Max-Size").empty());
}

TEST_F(UploadsApiTest, PiecesBecomeALayer) {
  const std::string text = kTrajectory;
  const std::string path = Create(text.size(), {{"Upload-Metadata", "filename cGF0aC50eHQ="}});
  EXPECT_THAT(path, StartsWith("/v1/uploads/"));
  const auto first = Patch(path, 0, text.substr(0, 20));
  EXPECT_EQ(first.status, 204) << first.body;
  EXPECT_EQ(first.headers.Get("Upload-Offset"), "20");
  EXPECT_EQ(first.headers.Get("Tus-Resumable"), "1.0.0");
  EXPECT_THAT(std::string(first.headers.Get("Upload-Expires")), HasSubstr(" GMT"));
  const auto asked = Tus("HEAD", path);
  EXPECT_EQ(asked.status, 200);
  EXPECT_EQ(asked.headers.Get("Upload-Offset"), "20");
  EXPECT_EQ(asked.headers.Get("Upload-Length"), std::to_string(text.size()));
  EXPECT_EQ(asked.headers.Get("Upload-Metadata"), "filename cGF0aC50eHQ=");
  EXPECT_EQ(asked.headers.Get("Cache-Control"), "no-store");
  EXPECT_EQ(PutReference("trajectory", path).status, 422);  // not whole yet
  const auto last = Patch(path, 20, text.substr(20));
  EXPECT_EQ(last.headers.Get("Upload-Sha256"), Sha256Hex(text));

  const auto put = PutReference("trajectory", path);
  ASSERT_EQ(put.status, 201) << put.body;
  const auto layer = Json(put)["version"]["layers"][0];
  EXPECT_EQ(layer["file_name"], "path.txt");
  EXPECT_EQ(layer["sha256"], Sha256Hex(text));
  EXPECT_EQ(layer["facts"]["poses"], "3");
  EXPECT_EQ(Get("/v1/environments/lab/versions/1/layers/trajectory").body, text);

  // A second reference, by the id alone and with a name of its own.
  const auto again = PutReference("trajectory", path.substr(path.rfind('/') + 1), "other.txt");
  ASSERT_EQ(again.status, 201) << again.body;
  EXPECT_EQ(Json(again)["version"]["layers"][0]["file_name"], "other.txt");
  EXPECT_EQ(Tus("DELETE", path).status, 204);
  EXPECT_EQ(Tus("HEAD", path).status, 404);
  EXPECT_EQ(PutReference("trajectory", path).status, 404);
  EXPECT_EQ(Get("/v1/environments/lab/versions/2/layers/trajectory").body, text);
  EXPECT_TRUE(store_->Verify().empty());
}

TEST_F(UploadsApiTest, TheFirstPieceMayComeWithTheCreation) {
  const auto created = Tus("POST", "/v1/uploads", {{"Upload-Length", "6"}}, "abc");
  EXPECT_EQ(created.status, 201) << created.body;
  EXPECT_EQ(created.headers.Get("Upload-Offset"), "3");
  EXPECT_EQ(Offset(std::string(created.headers.Get("Location"))), "3");
  EXPECT_EQ(Tus("POST", "/v1/uploads", {{"Upload-Length", "2"}}, "abc").status, 413);
}

TEST_F(UploadsApiTest, ALayerThatIsNotWhatItSaysIsRefusedAndTheUploadStays) {
  const std::string path = Create(9);
  Patch(path, 0, "no octree");
  EXPECT_EQ(PutReference("octomap", path).status, 422);
  EXPECT_EQ(Offset(path), "9");
  EXPECT_EQ(PutReference("features", path).status, 201);
}

TEST_F(UploadsApiTest, PiecesAreCheckedAgainstTheirChecksum) {
  const std::string path = Create(6);
  // SHA-256 of "abc" and of nothing.
  const std::string of_abc = "sha256 ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=";
  const std::string of_nothing = "sha256 47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=";
  const auto wrong = Patch(path, 0, "abc", {{"Upload-Checksum", of_nothing}});
  EXPECT_EQ(wrong.status, 460);
  EXPECT_EQ(Json(wrong)["code"], "checksum-mismatch");
  EXPECT_EQ(Offset(path), "0");
  EXPECT_EQ(Patch(path, 0, "abc", {{"Upload-Checksum", of_abc}}).status, 204);
  EXPECT_EQ(Patch(path, 3, "abc", {{"Upload-Checksum", "md5 kAFQmDzST7DWlj99KOF/cg=="}}).status,
            400);
  EXPECT_EQ(Patch(path, 3, "abc", {{"Upload-Checksum", of_abc}}).headers.Get("Upload-Sha256"),
            Sha256Hex("abcabc"));
}

TEST_F(UploadsApiTest, RequestsThatDoNotFitAreRefusedByName) {
  const std::string path = Create(6);
  EXPECT_EQ(Patch(path, 3, "abc").status, 409);
  EXPECT_EQ(Patch(path, 0, "abcdefg").status, 413);
  EXPECT_EQ(Tus("PATCH", path, {}, "abc").status, 400);  // no Upload-Offset
  EXPECT_EQ(Patch("/v1/uploads/" + std::string(32, '0'), 0, "abc").status, 404);
  EXPECT_EQ(Patch("/v1/uploads/..%2f..%2fetc", 0, "abc").status, 404);
  EXPECT_EQ(Send("PATCH", path, "text/plain", "abc", "Tus-Resumable", "1.0.0").status, 415);
  EXPECT_EQ(Patch(path, 0, "abc", {{"Content-Encoding", "zstd"}}).status, 415);
  EXPECT_EQ(Tus("POST", "/v1/uploads").status, 400);
  EXPECT_EQ(Tus("POST", "/v1/uploads", {{"Upload-Length", "-1"}}).status, 400);
  EXPECT_EQ(Tus("POST", "/v1/uploads", {{"Upload-Length", "9000000000000000000"}}).status, 413);
  EXPECT_EQ(Tus("POST", "/v1/uploads", {{"Upload-Defer-Length", "1"}}).status, 400);
  EXPECT_EQ(Tus("POST", "/v1/uploads", {{"Upload-Length", "1"}, {"Upload-Metadata", "a ?"}}).status,
            400);
  EXPECT_EQ(Get(path).status, 405);
  EXPECT_EQ(Offset(path), "0");
}

TEST_F(UploadsApiTest, AnotherVersionOfTusIsRefusedWithTheOneThatIsSpoken) {
  const std::string path = Create(6);
  for (const std::string version : {"", "0.2.2"}) {
    http::ClientRequest request{"DELETE", path, {}, {}, {}};
    if (!version.empty()) request.headers.Set("Tus-Resumable", version);
    const auto refused = client_->Send(request);
    EXPECT_EQ(refused.status, 412);
    EXPECT_EQ(refused.headers.Get("Tus-Version"), "1.0.0");
  }
  EXPECT_EQ(Offset(path), "0");
}

TEST_F(UploadsApiTest, MethodsCanBeOverridden) {
  const std::string path = Create(3);
  EXPECT_EQ(Tus("POST", path, {{"X-HTTP-Method-Override", "PATCH"}, {"Upload-Offset", "0"}}, "abc")
                .status,
            204);
  EXPECT_EQ(Tus("POST", path).status, 405);
  EXPECT_EQ(Tus("POST", path, {{"X-HTTP-Method-Override", "DELETE"}}).status, 204);
  EXPECT_EQ(Tus("HEAD", path).status, 404);
}

TEST_F(UploadsApiTest, OfTwoPiecesAtOnceOneIsToldToWait) {
  const std::string path = Create(6);
  const auto writer = store_->uploads().Continue(path.substr(path.rfind('/') + 1), 0,
                                                 store::Pieces::kAnyPart);  // the other request
  const auto second = Patch(path, 0, "abc");
  EXPECT_EQ(second.status, 423);
  EXPECT_EQ(Json(second)["code"], "upload-locked");
  EXPECT_EQ(second.headers.Get("Retry-After"), "1");
  EXPECT_EQ(Tus("DELETE", path).status, 423);
  EXPECT_EQ(Tus("HEAD", path).status, 200);
}

TEST_F(UploadsApiTest, WhatArrivedBeforeTheConnectionBrokeIsKept) {
  const std::string path = Create(100);
  {
    http::RawClient broken(server_->port());
    broken.Say("PATCH " + path +
               " HTTP/1.1\r\nHost: localhost\r\nTus-Resumable: 1.0.0\r\nUpload-Offset: 0\r\n"
               "Content-Type: application/offset+octet-stream\r\nContent-Length: 100\r\n\r\n" +
               std::string(40, 'a'));
  }
  // The server notices when it reads the end.
  for (int i = 0; i < 100 && Offset(path) != "40"; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(Offset(path), "40");
  const auto rest = Patch(path, 40, std::string(60, 'b'));
  EXPECT_EQ(rest.headers.Get("Upload-Sha256"),
            Sha256Hex(std::string(40, 'a') + std::string(60, 'b')));
}

TEST_F(UploadsApiTest, AFileIsGivenByItsHashForEverAndOnlyWhenItIsReferredTo) {
  const std::string link = "/v1/blobs/" + Sha256Hex(kTrajectory);
  const std::string path = Create(std::string(kTrajectory).size());
  Patch(path, 0, kTrajectory);
  EXPECT_EQ(Get(link).status, 404);
  const auto put = PutReference("trajectory", path, "my path.txt");
  EXPECT_EQ(Json(put)["version"]["layers"][0]["href"], link + "?name=my%20path.txt");

  const auto blob = Get(link);
  EXPECT_EQ(blob.status, 200);
  EXPECT_EQ(blob.body, kTrajectory);
  EXPECT_EQ(blob.headers.Get("ETag"), "\"" + Sha256Hex(kTrajectory) + "\"");
  EXPECT_EQ(blob.headers.Get("Cache-Control"), "public, max-age=31536000, immutable");
  EXPECT_EQ(blob.headers.Get("Content-Type"), "text/plain");
  EXPECT_THAT(std::string(blob.headers.Get("Content-Disposition")), HasSubstr("my path.txt"));
  EXPECT_EQ(Get(link, "If-None-Match", std::string(blob.headers.Get("ETag"))).status, 304);
  const auto part = Get(link, "Range", "bytes=4-6");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, std::string(kTrajectory).substr(4, 3));

  http::ClientRequest named{"GET", link, {{"name", "../map.pgm"}}, {}, {}};
  EXPECT_EQ(client_->Send(named).headers.Get("Content-Type"), "image/x-portable-graymap");
  EXPECT_THAT(std::string(client_->Send(named).headers.Get("Content-Disposition")),
              HasSubstr("\"map.pgm\""));
  named.query = {{"name", "page.html"}};  // never a page of ours
  EXPECT_EQ(client_->Send(named).headers.Get("Content-Type"), "text/plain");
  EXPECT_EQ(Get("/v1/blobs/" + Sha256Hex("never")).status, 404);
  EXPECT_EQ(Get("/v1/blobs/..%2f..%2flares.sqlite").status, 404);
}

TEST_F(UploadsApiTest, LayersTravelCompressedBothWays) {
  std::string long_path;
  for (int i = 0; i < 500; ++i) long_path += std::to_string(i) + ".0 0 0 0 0 0 0 1\n";
  std::string form =
      "--b\r\nContent-Disposition: form-data; name=\"trajectory\"; filename=\"p.txt\"\r\n\r\n" +
      long_path + "\r\n--b--\r\n";
  std::string encoded;
  http::ZstdEncoder encoder;
  encoder.Feed(form, [&](std::string_view piece) { encoded += piece; });
  encoder.End([&](std::string_view piece) { encoded += piece; });
  const auto put = Send("POST", "/v1/environments/lab/versions", "multipart/form-data; boundary=b",
                        encoded, "Content-Encoding", "zstd");
  ASSERT_EQ(put.status, 201) << put.body;

  const auto got =
      Get("/v1/environments/lab/versions/1/layers/trajectory", "Accept-Encoding", "zstd");
  EXPECT_EQ(got.headers.Get("Content-Encoding"), "zstd");
  std::string decoded;
  http::ZstdDecoder decoder({});
  decoder.Feed(got.body, [&](std::string_view piece) { decoded += piece; });
  EXPECT_EQ(decoded, long_path);
}

}  // namespace
}  // namespace lares::testing
