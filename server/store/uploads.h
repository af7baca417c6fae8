// Uploads under way: files that arrive in pieces, over broken connections and restarts.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/hash.h"
#include "base/time.h"
#include "server/store/blobs.h"
#include "server/store/files.h"
#include "server/store/health.h"

namespace lares::store {

struct UploadLimits {
  std::size_t max_count = 256;
  std::uint64_t max_bytes = std::uint64_t{64} << 30;            // announced, of one
  std::uint64_t max_total_bytes = std::uint64_t{256} << 30;     // announced, of all
  std::chrono::milliseconds lifetime = std::chrono::hours(24);  // after the last byte
  // While one piece is taken in, so much of it is at stake when the machine fails.
  std::uint64_t checkpoint_bytes = std::uint64_t{32} << 20;
};

struct UploadInfo {
  std::string id;            // 32 hexadecimal digits that nobody can guess
  std::uint64_t length = 0;  // announced
  std::uint64_t offset = 0;  // bytes that are here and synced
  std::string metadata;      // as the client wrote it; not interpreted
  Time expires{};
  std::string sha256;  // of the whole; empty until it is whole
  bool is_whole() const { return !sha256.empty(); }
};

// Somebody else writes to the upload, takes it or removes it at this moment.
class UploadBusyError : public Error {
 public:
  explicit UploadBusyError(const std::string& id)
      : Error(Code::kConflict, "upload '" + id + "' is being used by another request") {}
};

// Takes in one piece. Used by one thread; nobody else has the upload meanwhile.
class UploadWriter {
 public:
  virtual ~UploadWriter() = default;  // forgets what was not kept
  // Throws kTooLarge beyond the announced length, kUnavailable when there is no room; what was kept
  // stays.
  virtual void Append(std::string_view bytes) = 0;
  // What was appended survives a power cut when this returns. The last byte makes the upload whole.
  virtual UploadInfo Keep() = 0;
};

enum class Pieces {
  kAnyPart,     // what arrived of a piece may be kept from time to time
  kWholeOrNot,  // only Keep() keeps
};

// A whole upload that is about to become a blob. Nobody else has it meanwhile.
class UploadClaim {
 public:
  virtual ~UploadClaim() = default;
  virtual const UploadInfo& info() const = 0;
  virtual std::filesystem::path path() const = 0;  // of its bytes, for format checks
  // The upload stays, so that it can be referred to again; its bytes are the blob's.
  virtual Blob Adopt() = 0;
};

// uploads/<id>/ with the bytes in `data` and the rest in `state.json`. What is there is the truth:
// nothing has to be read at the start, and a lock in each folder keeps two requests, or servers,
// from the same upload. All members are thread-safe. Throws kNotFound (no such upload, or expired),
// UploadBusyError, kUnavailable (as Store says).
class Uploads {
 public:
  // Creates uploads/ in `folder` and removes what has expired.
  Uploads(const std::filesystem::path& folder, Files& files, Health& health, BlobFolder& blobs,
          const UploadLimits& limits = {});

  const UploadLimits& limits() const { return limits_; }

  // Throws kTooLarge for more than one may have, kUnavailable when there are too many.
  UploadInfo Create(std::uint64_t length, const std::string& metadata);
  UploadInfo Find(const std::string& id) const;
  // Throws kConflict when the upload has not `offset` bytes.
  std::unique_ptr<UploadWriter> Continue(const std::string& id, std::uint64_t offset,
                                         Pieces pieces);
  // Throws kConflict when it is not whole.
  std::unique_ptr<UploadClaim> Claim(const std::string& id);
  void Remove(const std::string& id);

 private:
  class Lock;
  class Writer;
  class Claimed;
  // The hash of the bytes taken in so far, which spares reading them again.
  struct Running {
    Sha256 hash;
    std::uint64_t size = 0;
  };

  std::filesystem::path FolderOf(const std::string& id) const;
  std::filesystem::path DataOf(const std::string& id) const { return FolderOf(id) / "data"; }
  UploadInfo Read(const std::string& id) const;
  void Save(const UploadInfo& info);
  void Sweep();
  void RemoveFolder(const std::string& id);
  void CheckRoom(std::uint64_t length) const;

  Running TakeRunning(const UploadInfo& info);
  void KeepRunning(const std::string& id, Running running);

  std::filesystem::path folder_;
  Files& files_;
  Health& health_;
  BlobFolder& blobs_;
  const UploadLimits limits_;
  std::mutex create_mutex_;  // the limits hold for all together
  std::mutex running_mutex_;
  std::map<std::string, Running> running_;
};

}  // namespace lares::store
