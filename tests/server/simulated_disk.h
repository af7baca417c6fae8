// A disk on which any operation can be made to fail, and which forgets at a power cut what was not
// synced. It does its work in a real folder, so that SQLite can read there, and keeps beside it
// what would be left of each file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/files.h"

namespace lares::store::testing {

enum class Fault {
  kNone,
  kError,     // that one operation fails; half of it is done when it is a write
  kFull,      // from then on nothing can be created or written
  kPowerCut,  // from then on nothing works; half of a write is done
};

enum class Unsynced { kKept, kLost, kSomeLost };

// Of the store's files, those that SQLite opens through vfs() and those made through Files. May be
// used from any thread; must outlive the store.
class SimulatedDisk final : public Files {
 public:
  explicit SimulatedDisk(const std::filesystem::path& folder);  // empty, and durable as it is
  ~SimulatedDisk() override;

  const std::filesystem::path& folder() const { return folder_; }
  const std::string& vfs() const { return vfs_name_; }

  // Makes operation number `at`, counted from now and from 1, fail.
  void FailAt(int at, Fault fault);
  bool has_failed() const;
  int operations() const;  // since FailAt
  // Called before each operation with its name and path; may block.
  void set_observer(std::function<void(std::string_view, const std::filesystem::path&)> observer);

  // After the store was closed: the machine works again. kKept: only the process had died, and what
  // was not synced is still neither lost nor safe.
  void Restart(Unsynced unsynced, unsigned seed = 0);

  std::unique_ptr<OutputFile> Create(const std::filesystem::path& path) override;
  std::unique_ptr<OutputFile> Reopen(const std::filesystem::path& path,
                                     std::uint64_t size) override;
  void Rename(const std::filesystem::path& from, const std::filesystem::path& to) override;
  void Remove(const std::filesystem::path& path) override;
  void MakeFolder(const std::filesystem::path& path) override;
  void SyncFolder(const std::filesystem::path& path) override;

 private:
  struct Change {
    std::uint64_t offset = 0;
    std::string bytes;
    bool truncates = false;  // to `offset`
  };
  struct Node {
    bool is_folder = false;
    std::string durable;           // the content that a power cut leaves
    std::vector<Change> unsynced;  // made since, oldest first
  };
  using Names = std::map<std::filesystem::path, std::shared_ptr<Node>>;
  class File;
  struct Vfs;

  std::shared_ptr<Node> Open(const std::filesystem::path& path);  // creates the name when absent
  // How many of `bytes` may be written.
  std::size_t Write(Node& node, const std::filesystem::path& path, std::uint64_t offset,
                    std::string_view bytes);
  void Truncate(Node& node, const std::filesystem::path& path, std::uint64_t size);
  void Sync(Node& node, const std::filesystem::path& path);

  // Throws when this operation is to fail as a whole.
  void Begin(std::string_view operation, const std::filesystem::path& path);
  // Whether this operation fails; for a write, after half of it.
  bool Fails(std::string_view operation);
  [[noreturn]] void ThrowFault(const std::filesystem::path& path) const;
  static void Apply(const Change& change, std::string& content);
  Names Survivors(Unsynced unsynced, unsigned seed) const;

  std::filesystem::path folder_;
  std::string vfs_name_;
  std::unique_ptr<Vfs> vfs_;
  std::function<void(std::string_view, const std::filesystem::path&)> observer_;

  mutable std::recursive_mutex mutex_;
  Names names_;          // as programs see them
  Names durable_names_;  // as a power cut leaves them
  Fault fault_ = Fault::kNone;
  int fail_at_ = 0;
  int operations_ = 0;
  bool failed_ = false;
};

}  // namespace lares::store::testing
