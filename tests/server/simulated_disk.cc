#include "tests/server/simulated_disk.h"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "tests/server/simulated_vfs.h"

namespace lares::store::testing {

namespace fs = std::filesystem;

class SimulatedDisk::File final : public OutputFile {
 public:
  File(SimulatedDisk& disk, std::shared_ptr<Node> node, const fs::path& path)
      : disk_(disk), node_(std::move(node)), path_(path), real_(path, std::ios::binary) {}
  File(SimulatedDisk& disk, std::shared_ptr<Node> node, const fs::path& path, std::uint64_t size)
      : disk_(disk),
        node_(std::move(node)),
        path_(path),
        real_(path, std::ios::binary | std::ios::app),
        size_(size) {}

  void Append(std::string_view bytes) override {
    const std::size_t allowed = disk_.Write(*node_, path_, size_, bytes);
    real_.write(bytes.data(), static_cast<std::streamsize>(allowed)).flush();
    size_ += allowed;
    if (allowed < bytes.size()) disk_.ThrowFault(path_);
  }
  void Sync() override { disk_.Sync(*node_, path_); }

 private:
  SimulatedDisk& disk_;
  std::shared_ptr<Node> node_;
  fs::path path_;
  std::ofstream real_;
  std::uint64_t size_ = 0;
};

// What SQLite does, done through the disk.
struct SimulatedDisk::Vfs final : SqliteFiles {
  struct OpenFile final : SqliteFile {
    OpenFile(SimulatedDisk& d, std::shared_ptr<Node> n, fs::path p)
        : disk(d), node(std::move(n)), path(std::move(p)) {}
    std::size_t Write(std::uint64_t offset, std::string_view bytes) override {
      return disk.Write(*node, path, offset, bytes);
    }
    void Truncate(std::uint64_t size) override { disk.Truncate(*node, path, size); }
    void Sync() override { disk.Sync(*node, path); }
    SimulatedDisk& disk;
    std::shared_ptr<Node> node;
    fs::path path;
  };

  explicit Vfs(SimulatedDisk& d) : disk(d), name(Register(*this)) {}
  ~Vfs() override { Unregister(name); }
  std::unique_ptr<SqliteFile> Open(const fs::path& path) override {
    return std::make_unique<OpenFile>(disk, disk.Open(path), path);
  }
  void SyncFolder(const fs::path& path) override { disk.SyncFolder(path); }
  // The real file is SQLite's to remove.
  void Remove(const fs::path& path) override {
    const std::lock_guard lock(disk.mutex_);
    disk.Begin("remove", path);
    disk.names_.erase(path);
  }
  int error() const override { return disk.fault_ == Fault::kFull ? ENOSPC : EIO; }

  SimulatedDisk& disk;
  std::string name;
};

SimulatedDisk::SimulatedDisk(const fs::path& folder)
    : folder_(fs::canonical(folder)), vfs_(std::make_unique<Vfs>(*this)) {
  vfs_name_ = vfs_->name;
}

SimulatedDisk::~SimulatedDisk() = default;

void SimulatedDisk::FailAt(int at, Fault fault) {
  const std::lock_guard lock(mutex_);
  fail_at_ = at;
  fault_ = fault;
  operations_ = 0;
  failed_ = false;
}

bool SimulatedDisk::has_failed() const {
  const std::lock_guard lock(mutex_);
  return failed_;
}

int SimulatedDisk::operations() const {
  const std::lock_guard lock(mutex_);
  return operations_;
}

void SimulatedDisk::set_observer(std::function<void(std::string_view, const fs::path&)> observer) {
  observer_ = std::move(observer);
}

bool SimulatedDisk::Fails(std::string_view operation) {
  ++operations_;
  if (fault_ == Fault::kNone || operations_ < fail_at_) return false;
  if (fault_ == Fault::kError && operations_ > fail_at_) return false;
  const bool needs_space = operation == "write" || operation == "create" || operation == "mkdir";
  if (fault_ == Fault::kFull && !needs_space) return false;
  failed_ = true;
  return true;
}

void SimulatedDisk::ThrowFault(const fs::path& path) const {
  throw std::system_error(fault_ == Fault::kFull ? ENOSPC : EIO, std::generic_category(),
                          "simulated fault at '" + path.string() + "'");
}

void SimulatedDisk::Begin(std::string_view operation, const fs::path& path) {
  if (Fails(operation)) ThrowFault(path);
}

std::shared_ptr<SimulatedDisk::Node> SimulatedDisk::Open(const fs::path& path) {
  if (observer_) observer_("create", path);
  const std::lock_guard lock(mutex_);
  if (const auto found = names_.find(path); found != names_.end()) return found->second;
  Begin("create", path);
  return names_[path] = std::make_shared<Node>();
}

std::size_t SimulatedDisk::Write(Node& node, const fs::path& path, std::uint64_t offset,
                                 std::string_view bytes) {
  if (observer_) observer_("write", path);
  const std::lock_guard lock(mutex_);
  const bool fails = Fails("write");
  const std::size_t allowed = fails ? bytes.size() / 2 : bytes.size();
  node.unsynced.push_back({offset, std::string(bytes.substr(0, allowed)), false});
  return allowed;
}

void SimulatedDisk::Truncate(Node& node, const fs::path& path, std::uint64_t size) {
  if (observer_) observer_("truncate", path);
  const std::lock_guard lock(mutex_);
  Begin("truncate", path);
  node.unsynced.push_back({size, "", true});
}

void SimulatedDisk::Apply(const Change& change, std::string& content) {
  const std::size_t end = change.offset + change.bytes.size();
  if (change.truncates || content.size() < end) content.resize(end);
  content.replace(change.offset, change.bytes.size(), change.bytes);
}

void SimulatedDisk::Sync(Node& node, const fs::path& path) {
  if (observer_) observer_("sync", path);
  const std::lock_guard lock(mutex_);
  const bool fails = Fails("sync");
  // A sync that fails leaves its pages marked as written: no later one brings them to the disk.
  if (!fails) {
    for (const Change& change : node.unsynced) Apply(change, node.durable);
  }
  if (!fails || fault_ == Fault::kError) node.unsynced.clear();
  if (fails) ThrowFault(path);
}

std::unique_ptr<OutputFile> SimulatedDisk::Create(const fs::path& path) {
  std::shared_ptr<Node> node = Open(path);
  return std::make_unique<File>(*this, std::move(node), path);
}

std::unique_ptr<OutputFile> SimulatedDisk::Reopen(const fs::path& path, std::uint64_t size) {
  std::shared_ptr<Node> node = Open(path);
  Truncate(*node, path, size);
  fs::resize_file(path, size);
  return std::make_unique<File>(*this, std::move(node), path, size);
}

void SimulatedDisk::Rename(const fs::path& from, const fs::path& to) {
  if (observer_) observer_("rename", to);
  const std::lock_guard lock(mutex_);
  Begin("rename", to);
  fs::rename(from, to);
  names_[to] = names_.at(from);
  names_.erase(from);
}

void SimulatedDisk::Remove(const fs::path& path) {
  if (observer_) observer_("remove", path);
  const std::lock_guard lock(mutex_);
  Begin("remove", path);
  fs::remove(path);
  names_.erase(path);
}

void SimulatedDisk::MakeFolder(const fs::path& path) {
  if (observer_) observer_("mkdir", path);
  const std::lock_guard lock(mutex_);
  if (names_.count(path) != 0) return;
  Begin("mkdir", path);
  fs::create_directory(path);
  names_[path] = std::make_shared<Node>(Node{true, "", {}});
}

void SimulatedDisk::SyncFolder(const fs::path& path) {
  if (observer_) observer_("sync-folder", path);
  const std::lock_guard lock(mutex_);
  Begin("sync-folder", path);
  std::erase_if(durable_names_, [&](const auto& entry) {
    return entry.first.parent_path() == path && names_.count(entry.first) == 0;
  });
  for (const auto& [name, node] : names_) {
    if (name.parent_path() == path) durable_names_[name] = node;
  }
}

// Each name with the content it has after the restart, in an order that has folders first.
SimulatedDisk::Names SimulatedDisk::Survivors(Unsynced unsynced, unsigned seed) const {
  std::mt19937 random(seed);
  const auto survives = [&] { return unsynced == Unsynced::kSomeLost && random() % 2 == 0; };
  Names names = durable_names_;
  for (const auto& [name, node] : names_) {
    if (durable_names_.count(name) == 0 && survives()) names[name] = node;
  }
  for (const auto& [name, node] : durable_names_) {
    const auto now = names_.find(name);
    if (now != names_.end() && now->second != node && survives()) names[name] = now->second;
    if (now == names_.end() && survives()) names.erase(name);
  }
  Names survivors;
  for (const auto& [name, node] : names) {
    const fs::path parent = name.parent_path();
    if (parent != folder_ && survivors.count(parent) == 0) continue;  // its folder is lost
    Node left{node->is_folder, node->durable, {}};
    for (const Change& change : node->unsynced) {
      if (survives()) Apply(change, left.durable);
    }
    survivors[name] = std::make_shared<Node>(std::move(left));
  }
  return survivors;
}

void SimulatedDisk::Restart(Unsynced unsynced, unsigned seed) {
  const std::lock_guard lock(mutex_);
  fault_ = Fault::kNone;
  if (unsynced == Unsynced::kKept) return;
  names_ = Survivors(unsynced, seed);
  durable_names_ = names_;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    fs::remove_all(entry.path());
  }
  for (const auto& [name, node] : names_) {
    if (node->is_folder) {
      fs::create_directory(name);
    } else {
      std::ofstream(name, std::ios::binary) << node->durable;
    }
  }
}

}  // namespace lares::store::testing
