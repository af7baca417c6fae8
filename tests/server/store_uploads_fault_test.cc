// The disk fails at every single operation of an upload, and no acknowledged byte is lost.
#include <gmock/gmock.h>

#include "base/hash.h"
#include "server/store/uploads.h"
#include "tests/server/simulated_disk.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

const std::string kBytes = "the first piece, the second piece, and the third";

struct Acknowledged {
  std::string id;
  std::uint64_t offset = 0;
  bool adopted = false;
};

// In three pieces; what was acknowledged is noted before the next step.
void Script(Uploads& uploads, Acknowledged& sure) {
  sure.id = uploads.Create(kBytes.size(), "").id;
  for (const std::uint64_t end : {std::size_t{17}, std::size_t{35}, kBytes.size()}) {
    const auto writer = uploads.Continue(sure.id, sure.offset, Pieces::kAnyPart);
    writer->Append(kBytes.substr(sure.offset, end - sure.offset));
    sure.offset = writer->Keep().offset;
  }
  uploads.Claim(sure.id)->Adopt();
  sure.adopted = true;
}

// After the restart: nothing less than what was acknowledged, nothing that was not sent, and the
// upload goes on to its end.
void GoesOn(Uploads& uploads, BlobFolder& blobs, const Acknowledged& sure) {
  if (sure.id.empty()) return;  // its creation was not acknowledged
  const UploadInfo found = uploads.Find(sure.id);
  EXPECT_GE(found.offset, sure.offset);
  if (!found.is_whole()) {
    const auto writer = uploads.Continue(sure.id, found.offset, Pieces::kAnyPart);
    writer->Append(kBytes.substr(found.offset));
    EXPECT_EQ(writer->Keep().sha256, Sha256Hex(kBytes));
  }
  EXPECT_EQ(blobs.Read(uploads.Claim(sure.id)->Adopt().sha256), kBytes);
}

bool Survives(int at, Fault fault, Unsynced unsynced) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  Acknowledged sure;
  {
    Health health;
    BlobFolder blobs(disk.folder(), disk, health);
    Uploads uploads(disk.folder(), disk, health, blobs);
    disk.FailAt(at, fault);
    try {
      Script(uploads, sure);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kUnavailable) << error.what();
    }
  }
  const bool reached = disk.has_failed();
  disk.Restart(unsynced, static_cast<unsigned>(at));
  Health health;
  BlobFolder blobs(disk.folder(), disk, health);
  Uploads uploads(disk.folder(), disk, health, blobs);
  try {
    GoesOn(uploads, blobs, sure);
  } catch (const Error& error) {
    ADD_FAILURE() << "operation " << at << ", fault " << static_cast<int>(fault) << ", unsynced "
                  << static_cast<int>(unsynced) << ", offset " << sure.offset << ", adopted "
                  << sure.adopted << ": " << error.what();
  }
  return reached;
}

TEST(UploadsFaultTest, NoAcknowledgedByteIsLostWhateverFails) {
  for (const Fault fault : {Fault::kError, Fault::kFull, Fault::kPowerCut}) {
    for (const Unsynced unsynced : {Unsynced::kKept, Unsynced::kLost, Unsynced::kSomeLost}) {
      int at = 1;
      while (Survives(at, fault, unsynced)) {
        ++at;
        ASSERT_LT(at, 500);
      }
      EXPECT_GT(at, 30);  // operations of the script
    }
  }
}

TEST(UploadsFaultTest, AFullDiskRefusesOnePieceAndWhatCameBeforeStays) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  Health health;
  BlobFolder blobs(disk.folder(), disk, health);
  Uploads uploads(disk.folder(), disk, health, blobs);
  const std::string id = uploads.Create(10, "").id;
  {
    const auto writer = uploads.Continue(id, 0, Pieces::kAnyPart);
    writer->Append("abcd");
    writer->Keep();
  }
  {
    const auto writer = uploads.Continue(id, 4, Pieces::kAnyPart);
    disk.FailAt(1, Fault::kFull);
    EXPECT_EQ(CodeOf([&] { writer->Append("efgh"); }), Code::kUnavailable);
  }
  EXPECT_EQ(health.reason(), "");
  disk.FailAt(0, Fault::kNone);
  EXPECT_EQ(uploads.Find(id).offset, 4U);
  const auto writer = uploads.Continue(id, 4, Pieces::kAnyPart);
  writer->Append("efghij");
  EXPECT_EQ(writer->Keep().sha256, Sha256Hex("abcdefghij"));
}

}  // namespace
}  // namespace lares::store::testing
