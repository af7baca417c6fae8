// Large layers over connections that break, and maps in dead zones.
#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "base/file.h"
#include "base/hash.h"
#include "server/cli/cache.h"
#include "tests/server/cli/cli_fixture.h"
#include "tests/server/cli/flaky_proxy.h"

namespace lares::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::size_t kLarge = 20'000'000;

// Bytes that differ everywhere, so that a piece at the wrong place is noticed.
std::string Noise(std::size_t size, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::string bytes(size, '\0');
  for (std::size_t at = 0; at + 8 <= size; at += 8) {
    const std::uint64_t value = random();
    std::memcpy(bytes.data() + at, &value, 8);
  }
  return bytes;
}

class CliTransfersTest : public CliTest {
 protected:
  fs::path Out(const std::string& name) const { return folder_ / name; }
  fs::path Partial(const std::string& bytes) const {
    return folder_ / "cache" / "lares" / "partial" / Sha256Hex(bytes);
  }
  fs::path Cached(const std::string& bytes) const {
    const std::string sha256 = Sha256Hex(bytes);
    return folder_ / "cache" / "lares" / "blobs" / sha256.substr(0, 2) / sha256;
  }
  Outcome Put(const fs::path& file, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"environment", "put", "lab", "--layer",
                                          "features=" + file.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Lares(arguments);
  }
  Outcome GetLab(const std::string& out, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"environment", "get", "lab", "--out", Out(out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Lares(arguments);
  }
  std::string Stored() {
    return store_->ReadBlob(store_->GetVersion("lab", 0).layers[0].blob.sha256);
  }
  std::size_t Uploads() const {
    return static_cast<std::size_t>(std::distance(
        fs::directory_iterator(folder_ / "data" / "uploads"), fs::directory_iterator()));
  }
  void StopServer() {
    url_ = server_->url();  // nobody listens there any more
    server_.reset();
  }
};

TEST_F(CliTransfersTest, ALargeLayerGoesOnWhereTheConnectionBroke) {
  const std::string bytes = Noise(kLarge);
  const fs::path file = Write("map.bin", bytes);
  FlakyProxy proxy(server_->port(), 3, 5'000'000);
  url_ = proxy.url();
  const Outcome put = Put(file);
  ASSERT_EQ(put.code, 0) << put.err;
  EXPECT_THAT(put.err, HasSubstr("trying again"));
  EXPECT_EQ(proxy.broken(), 3);
  EXPECT_LT(proxy.carried(), kLarge + 3'000'000) << "sent from the beginning";
  EXPECT_EQ(Stored(), bytes);
  EXPECT_EQ(Uploads(), 0U);
}

TEST_F(CliTransfersTest, AnotherProcessGoesOnWithResume) {
  const std::string bytes = Noise(kLarge);
  const fs::path file = Write("map.bin", bytes);
  {
    FlakyProxy proxy(server_->port(), 1000, 8'000'000);
    url_ = proxy.url();
    const Outcome put = Put(file, {"--patience", "0"});
    EXPECT_EQ(put.code, 1);
    EXPECT_THAT(put.err, HasSubstr("--resume"));
    EXPECT_EQ(Uploads(), 1U);
  }
  // Through an address of its own, where nothing was begun, all is sent.
  url_ = "";
  FlakyProxy proxy(server_->port(), 0, 0);
  const std::string note_folder = (folder_ / "cache" / "lares" / "uploads").string();
  for (const auto& entry : fs::directory_iterator(note_folder)) {
    const std::string path = ReadFile(entry.path());
    fs::remove(entry.path());
    const std::string name =
        Sha256Hex(proxy.url() + "\n" + Sha256Hex(bytes)).substr(0, 32);  // as if begun there
    std::ofstream(fs::path(note_folder) / name) << path;
    break;
  }
  url_ = proxy.url();
  const Outcome put = Put(file, {"--resume"});
  ASSERT_EQ(put.code, 0) << put.err;
  EXPECT_LT(proxy.carried(), kLarge - 4'000'000);
  EXPECT_EQ(Stored(), bytes);
}

TEST_F(CliTransfersTest, ResumeBeginsAnewWhenTheServerHasForgotten) {
  const fs::path file = Write("map.bin", Noise(kLarge));
  const std::string name =
      Sha256Hex(server_->url() + "\n" + Sha256Hex(Noise(kLarge))).substr(0, 32);
  fs::create_directories(folder_ / "cache" / "lares" / "uploads");
  std::ofstream(folder_ / "cache" / "lares" / "uploads" / name)
      << "/v1/uploads/" << std::string(32, 'a');
  const Outcome put = Put(file, {"--resume"});
  ASSERT_EQ(put.code, 0) << put.err;
}

TEST_F(CliTransfersTest, AServerThatIsAwayFromTheStartIsToldAtOnce) {
  const fs::path file = Write("map.bin", Noise(kLarge));
  StopServer();
  EXPECT_EQ(Put(file).code, 6);
  EXPECT_EQ(Put(Write("small.bin", "small")).code, 6);
}

TEST_F(CliTransfersTest, ADownloadGoesOnWhereTheConnectionBroke) {
  const std::string bytes = Noise(kLarge);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  FlakyProxy proxy(server_->port(), 3, 5'000'000);
  url_ = proxy.url();
  const Outcome get = GetLab("lab");
  ASSERT_EQ(get.code, 0) << get.err;
  EXPECT_EQ(proxy.broken(), 3);
  EXPECT_LT(proxy.carried(), kLarge + 3'000'000);
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), bytes);
}

TEST_F(CliTransfersTest, TheNextCallGoesOnWithWhatTheOneBeforeGot) {
  const std::string bytes = Noise(kLarge);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  {
    FlakyProxy proxy(server_->port(), 1000, 8'000'000);
    url_ = proxy.url();
    EXPECT_EQ(GetLab("lab", {"--patience", "0"}).code, 1);
    EXPECT_FALSE(fs::exists(Out("lab")));
    EXPECT_GT(fs::file_size(Partial(bytes)), 4'000'000U);
  }
  FlakyProxy proxy(server_->port(), 0, 0);
  url_ = proxy.url();
  ASSERT_EQ(GetLab("lab").code, 0);
  EXPECT_LT(proxy.carried(), kLarge - 4'000'000);
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), bytes);
}

TEST_F(CliTransfersTest, ADamagedPartialIsGotAnew) {
  const std::string bytes = Noise(100'000);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  for (const std::size_t size : {std::size_t{50'000}, bytes.size(), bytes.size() + 10}) {
    fs::create_directories(Partial(bytes).parent_path());
    std::ofstream(Partial(bytes), std::ios::binary) << std::string(size, 'x');
    fs::remove(Cached(bytes));
    const Outcome get = GetLab("lab");
    ASSERT_EQ(get.code, 0) << get.err;
    EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), bytes);
  }
}

TEST_F(CliTransfersTest, WhatIsCachedIsNotSentAgainAndCheckedFirst) {
  const std::string bytes = Noise(1'000'000);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  ASSERT_EQ(GetLab("first").code, 0);
  {
    FlakyProxy proxy(server_->port(), 0, 0);
    url_ = proxy.url();
    ASSERT_EQ(GetLab("second").code, 0);
    EXPECT_LT(proxy.carried(), 10'000U);
    EXPECT_EQ(ReadFile(Out("second") / "features.bin"), bytes);
  }
  std::fstream(Cached(bytes), std::ios::in | std::ios::out) << "damage";
  url_ = "";
  ASSERT_EQ(GetLab("second").code, 0);
  EXPECT_EQ(ReadFile(Out("second") / "features.bin"), bytes);
  EXPECT_EQ(ReadFile(Cached(bytes)), bytes);
}

TEST_F(CliTransfersTest, ARobotInADeadZoneKeepsItsMap) {
  const std::string bytes = Noise(100'000);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  ASSERT_EQ(GetLab("lab").code, 0);
  StopServer();
  EXPECT_EQ(GetLab("lab").code, 6);
  EXPECT_TRUE(fs::exists(Out("lab") / "features.bin"));  // what was there stays
  const Outcome offline = GetLab("lab", {"--offline-ok"});
  ASSERT_EQ(offline.code, 0) << offline.err;
  EXPECT_THAT(offline.err, HasSubstr("no Lares server answers"));
  EXPECT_THAT(offline.err, HasSubstr("version 1 of lab as it was got"));
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), bytes);
  EXPECT_EQ(GetLab("lab", {"--offline-ok", "--version", "1"}).code, 0);
  EXPECT_EQ(GetLab("lab", {"--offline-ok", "--version", "7"}).code, 6);
  std::fstream(Cached(bytes), std::ios::in | std::ios::out) << "damage";
  EXPECT_EQ(GetLab("lab", {"--offline-ok"}).code, 4);
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), bytes);
}

TEST_F(CliTransfersTest, ANewVersionThatCannotBeGotWholeLeavesTheOldOne) {
  const std::string old_bytes = Noise(100'000, 1);
  ASSERT_EQ(Put(Write("map.bin", old_bytes)).code, 0);
  FlakyProxy proxy(server_->port(), 1000, 1'000'000);
  url_ = proxy.url();
  ASSERT_EQ(GetLab("lab").code, 0);
  url_ = "";
  ASSERT_EQ(Put(Write("map.bin", Noise(kLarge, 2))).code, 0);
  url_ = proxy.url();
  const Outcome get = GetLab("lab", {"--offline-ok", "--patience", "0"});
  ASSERT_EQ(get.code, 0) << get.err;
  EXPECT_THAT(get.err, HasSubstr("version 1 of lab"));
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), old_bytes);
}

TEST_F(CliTransfersTest, TheNewestVersionIsAskedForEachTime) {
  ASSERT_EQ(Put(Write("map.bin", "one")).code, 0);
  ASSERT_EQ(GetLab("lab").code, 0);
  ASSERT_EQ(GetLab("lab").code, 0);  // 304
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), "one");
  ASSERT_EQ(Put(Write("map.bin", "two")).code, 0);
  ASSERT_EQ(GetLab("lab").code, 0);
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), "two");
}

TEST_F(CliTransfersTest, TheCacheIsBoundedAndCanBeLeftOut) {
  const std::string bytes = Noise(3'000'000, 5);
  ASSERT_EQ(Put(Write("map.bin", bytes)).code, 0);
  ASSERT_EQ(GetLab("lab").code, 0);
  EXPECT_TRUE(fs::exists(Cached(bytes)));
  ASSERT_EQ(Put(Write("map.bin", "small")).code, 0);
  ASSERT_EQ(GetLab("lab", {"--cache-mb", "1"}).code, 0);
  EXPECT_FALSE(fs::exists(Cached(bytes)));
  EXPECT_TRUE(fs::exists(Cached("small")));
  fs::remove_all(folder_ / "cache");
  ASSERT_EQ(GetLab("lab", {"--cache-mb", "0"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(CliTransfersTest, ACacheThatCannotBeWrittenIsNoFault) {
  ASSERT_EQ(Put(Write("map.bin", "bytes")).code, 0);
  Write("cache", "a file where the folder should be");
  ASSERT_EQ(GetLab("lab").code, 0);
  EXPECT_EQ(ReadFile(Out("lab") / "features.bin"), "bytes");
}

}  // namespace
}  // namespace lares::testing
