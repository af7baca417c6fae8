#include <gmock/gmock.h>

#include <fstream>

#include "base/file.h"
#include "base/hash.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class BlobTest : public StoreTest {};

std::size_t FilesIn(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    count += entry.is_regular_file() && name != "lock" && name != "turn";
  }
  return count;
}

TEST_F(BlobTest, PiecesBecomeOneFileNamedByItsHash) {
  const auto writer = store_->NewBlob();
  writer->Append("one ");
  writer->Append("");
  writer->Append(std::string("two\0", 4));
  const Blob blob = writer->Commit();
  const std::string bytes("one two\0", 8);
  EXPECT_EQ(blob.sha256, Sha256Hex(bytes));
  EXPECT_EQ(blob.size, 8U);
  EXPECT_EQ(store_->ReadBlob(blob.sha256), bytes);
  EXPECT_EQ(store_->BlobPath(blob.sha256),
            folder_.path() / "blobs" / blob.sha256.substr(0, 2) / blob.sha256.substr(2));
  EXPECT_EQ(FilesIn(folder_.path() / "incoming"), 0U);
}

TEST_F(BlobTest, EmptyBlobIsABlob) {
  const Blob blob = store_->NewBlob()->Commit();
  EXPECT_EQ(blob.sha256, Sha256Hex(""));
  EXPECT_EQ(store_->ReadBlob(blob.sha256), "");
}

TEST_F(BlobTest, SameBytesTwiceAreOneFile) {
  EXPECT_EQ(PutBlob("same").sha256, PutBlob("same").sha256);
  EXPECT_EQ(FilesIn(folder_.path() / "blobs"), 1U);
}

TEST_F(BlobTest, DroppedWriterLeavesNothing) {
  {
    const auto writer = store_->NewBlob();
    writer->Append("half of it");
    EXPECT_TRUE(fs::exists(writer->path()));
  }
  EXPECT_EQ(FilesIn(folder_.path() / "incoming"), 0U);
  EXPECT_EQ(FilesIn(folder_.path() / "blobs"), 0U);
}

TEST_F(BlobTest, TemporaryFileHoldsAllThatWasAppended) {
  const auto writer = store_->NewBlob();
  writer->Append("checked before ");
  writer->Append("commit");
  writer->Flush();
  EXPECT_EQ(ReadFile(writer->path()), "checked before commit");
}

TEST_F(BlobTest, WriterIsSpentAfterCommit) {
  const auto writer = store_->NewBlob();
  writer->Append("x");
  writer->Commit();
  EXPECT_EQ(CodeOf([&] { writer->Append("y"); }), Code::kInternal);
  EXPECT_EQ(CodeOf([&] { writer->Commit(); }), Code::kInternal);
}

TEST_F(BlobTest, WritersAtTheSameTimeDoNotMeet) {
  const auto a = store_->NewBlob();
  const auto b = store_->NewBlob();
  a->Append("aa");
  b->Append("bb");
  a->Append("AA");
  EXPECT_EQ(store_->ReadBlob(b->Commit().sha256), "bb");
  EXPECT_EQ(store_->ReadBlob(a->Commit().sha256), "aaAA");
}

TEST_F(BlobTest, UnknownAndMalformedHashesAreNotFound) {
  for (const std::string& hash : {Sha256Hex("never put"), std::string(), std::string("../lares"),
                                  std::string(64, 'A'), "../../" + std::string(58, 'a')}) {
    EXPECT_EQ(CodeOf([&] { store_->BlobPath(hash); }), Code::kNotFound) << hash;
    EXPECT_EQ(CodeOf([&] { store_->ReadBlob(hash); }), Code::kNotFound) << hash;
  }
}

TEST_F(BlobTest, DamagedBlobIsNotHandedOutAndPuttingItAgainMendsIt) {
  const Blob blob = PutBlob("precious");
  std::ofstream(store_->BlobPath(blob.sha256)) << "precioux";
  EXPECT_EQ(CodeOf([&] { store_->ReadBlob(blob.sha256); }), Code::kIo);
  ASSERT_EQ(store_->Verify().size(), 1U);
  EXPECT_THAT(store_->Verify()[0], HasSubstr(blob.sha256));
  PutBlob("precious");
  EXPECT_EQ(store_->ReadBlob(blob.sha256), "precious");
}

TEST_F(BlobTest, LeftoversOfAnInterruptedUploadAreRemovedAtOpening) {
  const Blob blob = PutBlob("whole");
  const fs::path part =
      folder_.path() / "incoming" / (postgres_.empty() ? "" : "of-a-process-that-died");
  fs::create_directories(part);
  std::ofstream(part / "7") << "half";
  Reopen();
  EXPECT_EQ(FilesIn(folder_.path() / "incoming"), 0U);
  EXPECT_EQ(store_->ReadBlob(blob.sha256), "whole");
}

}  // namespace
}  // namespace lares::store::testing
