#include "server/store/uploads.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/file.h"
#include "base/hash.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A file system on which uploads and blobs lie on different devices.
class TwoDevices final : public Files {
 public:
  std::unique_ptr<OutputFile> Create(const fs::path& path) override {
    return RealFiles().Create(path);
  }
  std::unique_ptr<OutputFile> Reopen(const fs::path& path, std::uint64_t size) override {
    return RealFiles().Reopen(path, size);
  }
  void Rename(const fs::path& from, const fs::path& to) override {
    if (from.filename() == "data") {
      throw std::system_error(EXDEV, std::generic_category(), "simulated");
    }
    RealFiles().Rename(from, to);
  }
  void Remove(const fs::path& path) override { RealFiles().Remove(path); }
  void MakeFolder(const fs::path& path) override { RealFiles().MakeFolder(path); }
  void SyncFolder(const fs::path& path) override { RealFiles().SyncFolder(path); }
};

class UploadsTest : public ::testing::Test {
 protected:
  UploadsTest() { Open({}); }

  void Open(const UploadLimits& limits, Files& files = RealFiles()) {
    uploads_.reset();
    blobs_ = std::make_unique<BlobFolder>(folder_.path(), files, health_);
    uploads_ = std::make_unique<Uploads>(folder_.path(), files, health_, *blobs_, limits);
  }
  UploadInfo Send(const std::string& id, std::uint64_t offset, const std::string& bytes) {
    const auto writer = uploads_->Continue(id, offset, Pieces::kAnyPart);
    writer->Append(bytes);
    return writer->Keep();
  }
  fs::path Data(const std::string& id) const { return folder_.path() / "uploads" / id / "data"; }

  TemporaryFolder folder_{FastFolder()};
  Health health_;
  std::unique_ptr<BlobFolder> blobs_;
  std::unique_ptr<Uploads> uploads_;
};

TEST_F(UploadsTest, PiecesBecomeAWholeThatIsNamedByItsHashAndAdopted) {
  const UploadInfo begun = uploads_->Create(11, "filename cm9vbS5idA==");
  EXPECT_EQ(begun.offset, 0U);
  EXPECT_EQ(Send(begun.id, 0, "hello ").offset, 6U);
  EXPECT_FALSE(uploads_->Find(begun.id).is_whole());
  EXPECT_EQ(Send(begun.id, 6, "world").sha256, Sha256Hex("hello world"));
  EXPECT_EQ(uploads_->Find(begun.id).metadata, "filename cm9vbS5idA==");

  const auto claim = uploads_->Claim(begun.id);
  EXPECT_EQ(ReadFile(claim->path()), "hello world");
  EXPECT_EQ(claim->Adopt().sha256, Sha256Hex("hello world"));
  EXPECT_EQ(blobs_->Read(Sha256Hex("hello world")), "hello world");
  EXPECT_FALSE(fs::exists(Data(begun.id)));
}

TEST_F(UploadsTest, AnAdoptedUploadCanBeReferredToAgain) {
  const std::string id = uploads_->Create(3, "").id;
  Send(id, 0, "abc");
  uploads_->Claim(id)->Adopt();
  Open({});
  const auto again = uploads_->Claim(id);
  EXPECT_EQ(ReadFile(again->path()), "abc");
  EXPECT_EQ(again->Adopt().sha256, Sha256Hex("abc"));
}

TEST_F(UploadsTest, AnUploadWithoutBytesIsWholeAtOnce) {
  const UploadInfo empty = uploads_->Create(0, "");
  EXPECT_EQ(empty.sha256, Sha256Hex(""));
  EXPECT_EQ(uploads_->Claim(empty.id)->Adopt().size, 0U);
  EXPECT_EQ(blobs_->Read(Sha256Hex("")), "");
}

TEST_F(UploadsTest, WhatWasKeptIsThereAfterARestartAndItsHashIsThatOfAll) {
  const std::string id = uploads_->Create(6, "").id;
  Send(id, 0, "abc");
  Open({});
  EXPECT_EQ(uploads_->Find(id).offset, 3U);
  EXPECT_EQ(Send(id, 3, "def").sha256, Sha256Hex("abcdef"));
}

TEST_F(UploadsTest, BytesBeyondTheAcknowledgedOffsetAreCut) {
  const std::string id = uploads_->Create(6, "").id;
  Send(id, 0, "abc");
  std::ofstream(Data(id), std::ios::app) << "XY";  // a process died while it wrote
  EXPECT_EQ(uploads_->Find(id).offset, 3U);
  EXPECT_EQ(Send(id, 3, "def").sha256, Sha256Hex("abcdef"));
}

TEST_F(UploadsTest, TheOffsetIsNeverMoreThanTheFileHas) {
  const std::string id = uploads_->Create(6, "").id;
  Send(id, 0, "abcd");
  fs::resize_file(Data(id), 2);
  EXPECT_EQ(uploads_->Find(id).offset, 2U);
  EXPECT_EQ(Send(id, 2, "cdef").sha256, Sha256Hex("abcdef"));
}

TEST_F(UploadsTest, APieceThatIsNotKeptLeavesNothing) {
  const std::string id = uploads_->Create(6, "").id;
  Send(id, 0, "ab");
  uploads_->Continue(id, 2, Pieces::kWholeOrNot)->Append("XXX");
  EXPECT_EQ(uploads_->Find(id).offset, 2U);
  EXPECT_EQ(fs::file_size(Data(id)), 2U);
  EXPECT_EQ(Send(id, 2, "cdef").sha256, Sha256Hex("abcdef"));
}

TEST_F(UploadsTest, ALongPieceIsKeptFromTimeToTimeUnlessItIsToBeWhole) {
  UploadLimits limits;
  limits.checkpoint_bytes = 4;
  Open(limits);
  const std::string id = uploads_->Create(100, "").id;
  {
    const auto writer = uploads_->Continue(id, 0, Pieces::kAnyPart);
    for (int i = 0; i < 5; ++i) writer->Append("xy");
  }
  EXPECT_EQ(uploads_->Find(id).offset, 8U);
  {
    const auto writer = uploads_->Continue(id, 8, Pieces::kWholeOrNot);
    for (int i = 0; i < 5; ++i) writer->Append("xy");
  }
  EXPECT_EQ(uploads_->Find(id).offset, 8U);
  const std::string ends = uploads_->Create(8, "").id;  // exactly with a checkpoint
  EXPECT_EQ(Send(ends, 0, "abcdefgh").sha256, Sha256Hex("abcdefgh"));
}

TEST_F(UploadsTest, MoreBytesThanAnnouncedAreRefused) {
  const std::string id = uploads_->Create(3, "").id;
  EXPECT_EQ(CodeOf([&] { Send(id, 0, "abcd"); }), Code::kTooLarge);
  EXPECT_EQ(uploads_->Find(id).offset, 0U);
}

TEST_F(UploadsTest, ThereIsOnlyOneWriterAtATime) {
  const std::string id = uploads_->Create(6, "").id;
  const auto writer = uploads_->Continue(id, 0, Pieces::kAnyPart);
  EXPECT_THROW(uploads_->Continue(id, 0, Pieces::kAnyPart), UploadBusyError);
  EXPECT_THROW(uploads_->Remove(id), UploadBusyError);
  EXPECT_THROW(uploads_->Claim(id), UploadBusyError);
  EXPECT_EQ(uploads_->Find(id).offset, 0U);  // asking is always possible
}

TEST_F(UploadsTest, AnotherProcessIsKeptOutToo) {
  const std::string id = uploads_->Create(6, "").id;
  const auto writer = uploads_->Continue(id, 0, Pieces::kAnyPart);
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 2;
    try {
      Uploads others(folder_.path(), RealFiles(), health_, *blobs_);
      others.Continue(id, 0, Pieces::kAnyPart);
      code = 1;
    } catch (const UploadBusyError&) {
      code = 0;
    } catch (...) {
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(UploadsTest, OffsetsThatAreNotTheUploadsAreAConflict) {
  const std::string id = uploads_->Create(6, "").id;
  Send(id, 0, "abc");
  for (const std::uint64_t offset : {0U, 2U, 4U, 600U}) {
    EXPECT_EQ(CodeOf([&] { Send(id, offset, "x"); }), Code::kConflict) << offset;
  }
  EXPECT_EQ(CodeOf([&] { uploads_->Claim(id); }), Code::kConflict);
  Send(id, 3, "def");
  EXPECT_EQ(CodeOf([&] { Send(id, 6, ""); }), Code::kConflict);
}

TEST_F(UploadsTest, NumberAndSizeAreBounded) {
  UploadLimits limits;
  limits.max_count = 2;
  limits.max_bytes = 100;
  limits.max_total_bytes = 150;
  Open(limits);
  EXPECT_EQ(CodeOf([&] { uploads_->Create(101, ""); }), Code::kTooLarge);
  const std::string id = uploads_->Create(100, "").id;
  EXPECT_EQ(CodeOf([&] { uploads_->Create(51, ""); }), Code::kUnavailable);
  uploads_->Create(50, "");
  EXPECT_EQ(CodeOf([&] { uploads_->Create(0, ""); }), Code::kUnavailable);
  uploads_->Remove(id);
  EXPECT_EQ(CodeOf([&] { uploads_->Find(id); }), Code::kNotFound);
  EXPECT_FALSE(fs::exists(folder_.path() / "uploads" / id));
  EXPECT_NO_THROW(uploads_->Create(100, ""));
}

TEST_F(UploadsTest, ExpiredUploadsAreGoneAndTheirRoomIsFree) {
  UploadLimits limits;
  limits.max_count = 1;
  limits.lifetime = std::chrono::milliseconds(30);
  Open(limits);
  const std::string id = uploads_->Create(10, "").id;
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_EQ(CodeOf([&] { uploads_->Find(id); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { Send(id, 0, "x"); }), Code::kNotFound);
  EXPECT_TRUE(fs::exists(Data(id)));
  uploads_->Create(10, "");
  EXPECT_FALSE(fs::exists(Data(id)));
}

TEST_F(UploadsTest, WhatIsNoUploadIsNotFoundAndHalfMadeOnesAreRemoved) {
  for (const std::string id : {"", "..", "../../etc", "0123", std::string(32, 'g').c_str()}) {
    EXPECT_EQ(CodeOf([&] { uploads_->Find(id); }), Code::kNotFound) << id;
    EXPECT_EQ(CodeOf([&] { uploads_->Remove(id); }), Code::kNotFound) << id;
  }
  const std::string half(32, 'a');
  const std::string torn(32, 'b');
  for (const std::string& id : {half, torn}) fs::create_directory(Data(id).parent_path());
  std::ofstream(Data(half)) << "bytes without a state";
  std::ofstream(Data(torn).parent_path() / "state.json") << "{\"length\": 1";
  EXPECT_EQ(CodeOf([&] { uploads_->Find(torn); }), Code::kNotFound);
  Open({});
  EXPECT_TRUE(fs::is_empty(folder_.path() / "uploads"));
}

TEST_F(UploadsTest, OnAnotherDeviceTheBytesAreCopied) {
  TwoDevices files;
  Open({}, files);
  const std::string bytes(3'000'000, 'z');
  const std::string id = uploads_->Create(bytes.size(), "").id;
  Send(id, 0, bytes);
  uploads_->Claim(id)->Adopt();
  EXPECT_EQ(blobs_->Read(Sha256Hex(bytes)), bytes);
  EXPECT_FALSE(fs::exists(Data(id)));
  EXPECT_EQ(health_.reason(), "");
}

}  // namespace
}  // namespace lares::store::testing
