#include "tests/server/simulated_vfs.h"

#include <sqlite3.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <system_error>

namespace lares::store::testing {
namespace {

struct Vfs {
  sqlite3_vfs base{};
  sqlite3_vfs* real = nullptr;
  SqliteFiles* files = nullptr;
  std::string name;
};

// SQLite allocates this much and room for its own file behind it.
struct VfsFile {
  sqlite3_file base{};
  Vfs* vfs = nullptr;
  SqliteFile* allowed = nullptr;  // owned; null for a temporary file without a name
  std::filesystem::path folder;
  bool syncs_folder = false;  // with its first sync, as SQLite does for a new log
  sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

VfsFile& Of(sqlite3_file* file) { return *reinterpret_cast<VfsFile*>(file); }
sqlite3_file* Real(sqlite3_file* file) { return Of(file).real(); }
Vfs& Of(sqlite3_vfs* vfs) { return *reinterpret_cast<Vfs*>(vfs); }

// Runs `operation`; its fault as SQLite's code.
template <typename Operation>
int Asked(int code, Operation operation) {
  try {
    operation();
    return SQLITE_OK;
  } catch (const std::system_error& error) {
    return error.code().value() == ENOSPC ? SQLITE_FULL : code;
  }
}

int Close(sqlite3_file* file) {
  const int result =
      Real(file)->pMethods == nullptr ? SQLITE_OK : Real(file)->pMethods->xClose(Real(file));
  delete Of(file).allowed;
  Of(file).~VfsFile();
  return result;
}

int Write(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  VfsFile& self = Of(file);
  const std::string_view bytes(static_cast<const char*>(data), static_cast<std::size_t>(size));
  const std::size_t allowed = self.allowed == nullptr
                                  ? bytes.size()
                                  : self.allowed->Write(static_cast<std::uint64_t>(offset), bytes);
  const int result =
      self.real()->pMethods->xWrite(self.real(), data, static_cast<int>(allowed), offset);
  if (result != SQLITE_OK || allowed == bytes.size()) return result;
  return self.vfs->files->error() == ENOSPC ? SQLITE_FULL : SQLITE_IOERR_WRITE;
}

int Truncate(sqlite3_file* file, sqlite3_int64 size) {
  VfsFile& self = Of(file);
  const int result = Asked(SQLITE_IOERR_TRUNCATE, [&] {
    if (self.allowed != nullptr) self.allowed->Truncate(static_cast<std::uint64_t>(size));
  });
  return result != SQLITE_OK ? result : self.real()->pMethods->xTruncate(self.real(), size);
}

// Nothing reaches the real disk: what a power cut leaves is the simulation's to say.
int Sync(sqlite3_file* file, int) {
  VfsFile& self = Of(file);
  return Asked(SQLITE_IOERR_FSYNC, [&] {
    if (self.allowed == nullptr) return;
    self.allowed->Sync();
    if (self.syncs_folder) self.vfs->files->SyncFolder(self.folder);
    self.syncs_folder = false;
  });
}

int Read(sqlite3_file* f, void* to, int size, sqlite3_int64 at) {
  return Real(f)->pMethods->xRead(Real(f), to, size, at);
}
int FileSize(sqlite3_file* f, sqlite3_int64* size) {
  return Real(f)->pMethods->xFileSize(Real(f), size);
}
int Lock(sqlite3_file* f, int level) { return Real(f)->pMethods->xLock(Real(f), level); }
int Unlock(sqlite3_file* f, int level) { return Real(f)->pMethods->xUnlock(Real(f), level); }
int CheckReservedLock(sqlite3_file* f, int* result) {
  return Real(f)->pMethods->xCheckReservedLock(Real(f), result);
}
// Hints about the size would change the file beside Write.
int FileControl(sqlite3_file* f, int op, void* argument) {
  if (op == SQLITE_FCNTL_SIZE_HINT || op == SQLITE_FCNTL_CHUNK_SIZE) return SQLITE_OK;
  return Real(f)->pMethods->xFileControl(Real(f), op, argument);
}
int SectorSize(sqlite3_file* f) { return Real(f)->pMethods->xSectorSize(Real(f)); }
int Characteristics(sqlite3_file* f) { return Real(f)->pMethods->xDeviceCharacteristics(Real(f)); }
int ShmMap(sqlite3_file* f, int page, int size, int extend, void volatile** memory) {
  return Real(f)->pMethods->xShmMap(Real(f), page, size, extend, memory);
}
int ShmLock(sqlite3_file* f, int offset, int count, int flags) {
  return Real(f)->pMethods->xShmLock(Real(f), offset, count, flags);
}
void ShmBarrier(sqlite3_file* f) { Real(f)->pMethods->xShmBarrier(Real(f)); }
int ShmUnmap(sqlite3_file* f, int remove) { return Real(f)->pMethods->xShmUnmap(Real(f), remove); }

constexpr sqlite3_io_methods kMethods = {2,
                                         Close,
                                         Read,
                                         Write,
                                         Truncate,
                                         Sync,
                                         FileSize,
                                         Lock,
                                         Unlock,
                                         CheckReservedLock,
                                         FileControl,
                                         SectorSize,
                                         Characteristics,
                                         ShmMap,
                                         ShmLock,
                                         ShmBarrier,
                                         ShmUnmap,
                                         nullptr,
                                         nullptr};

int Open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  file->pMethods = nullptr;
  Vfs& self = Of(vfs);
  SqliteFile* allowed = nullptr;
  // Without kCreate, SQLite only looks whether the file is there.
  const bool creates = (flags & SQLITE_OPEN_CREATE) != 0;
  int exists = 0;
  if (name != nullptr) self.real->xAccess(self.real, name, SQLITE_ACCESS_EXISTS, &exists);
  if (name != nullptr && (creates || exists != 0)) {
    const int refused = Asked(SQLITE_CANTOPEN, [&] { allowed = self.files->Open(name).release(); });
    if (refused != SQLITE_OK) return refused;
  }
  auto* opened = new (file) VfsFile;
  opened->vfs = &self;
  opened->allowed = allowed;
  if (name != nullptr) opened->folder = std::filesystem::path(name).parent_path();
  opened->syncs_folder =
      creates && (flags & (SQLITE_OPEN_WAL | SQLITE_OPEN_MAIN_JOURNAL | SQLITE_OPEN_SUPER_JOURNAL));
  const int result = self.real->xOpen(self.real, name, opened->real(), flags, out_flags);
  file->pMethods = &kMethods;
  if (result != SQLITE_OK) {
    Close(file);
    file->pMethods = nullptr;
  }
  return result;
}

int Delete(sqlite3_vfs* vfs, const char* name, int sync_folder) {
  Vfs& self = Of(vfs);
  const int refused = Asked(SQLITE_IOERR_DELETE, [&] { self.files->Remove(name); });
  if (refused != SQLITE_OK) return refused;
  const int result = self.real->xDelete(self.real, name, 0);
  if (result != SQLITE_OK || sync_folder == 0) return result;
  return Asked(SQLITE_IOERR_DIR_FSYNC,
               [&] { self.files->SyncFolder(std::filesystem::path(name).parent_path()); });
}

}  // namespace

std::string Register(SqliteFiles& files) {
  static std::atomic<int> count{0};
  auto* vfs = new Vfs;
  vfs->real = sqlite3_vfs_find(nullptr);
  vfs->files = &files;
  vfs->name = "simulated-" + std::to_string(++count);
  vfs->base = *vfs->real;
  vfs->base.zName = vfs->name.c_str();
  vfs->base.pNext = nullptr;
  vfs->base.szOsFile = static_cast<int>(sizeof(VfsFile)) + vfs->real->szOsFile;
  // The other members do not look at the VFS they belong to, beside pAppData, which is copied.
  vfs->base.xOpen = Open;
  vfs->base.xDelete = Delete;
  if (sqlite3_vfs_register(&vfs->base, 0) != SQLITE_OK) std::abort();
  return vfs->name;
}

void Unregister(const std::string& name) {
  sqlite3_vfs* vfs = sqlite3_vfs_find(name.c_str());
  if (vfs == nullptr) return;
  sqlite3_vfs_unregister(vfs);
  delete &Of(vfs);
}

}  // namespace lares::store::testing
