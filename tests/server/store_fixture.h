// A store in a folder of its own, and short ways to fill it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "server/store/store.h"
#include "tests/server/own_postgres.h"

namespace lares::store::testing {

class TemporaryFolder {
 public:
  explicit TemporaryFolder(
      const std::filesystem::path& in = std::filesystem::temp_directory_path()) {
    std::string pattern = (in / "lares-store-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// In memory where the system has such a place: for what needs no real disk.
inline std::filesystem::path FastFolder() {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code ignored;
  return std::filesystem::is_directory(memory, ignored) ? memory
                                                        : std::filesystem::temp_directory_path();
}

// On SQLite; on a PostgreSQL of the tests' own where LARES_TEST_STORE is "postgres". Every test of
// this fixture is run on both.
class StoreTest : public ::testing::Test {
 protected:
  StoreTest() {
    const char* kind = std::getenv("LARES_TEST_STORE");
    if (kind != nullptr && std::string_view(kind) == "postgres") {
      postgres_ = SharedPostgres().NewDatabase();
    }
    Reopen();
  }

  // The same store, as another process would open it.
  void Reopen() {
    store_.reset();
    store_ = postgres_.empty() ? OpenSqliteStore({folder_.path()})
                               : OpenPostgresStore({postgres_, folder_.path()});
  }
  void TearDown() override {
    if (!store_) return;
    EXPECT_EQ(store_->Verify(), std::vector<std::string>{});
  }

  Blob PutBlob(const std::string& bytes) {
    const auto writer = store_->NewBlob();
    writer->Append(bytes);
    return writer->Commit();
  }

  TemporaryFolder folder_{FastFolder()};
  std::string postgres_;  // the connection; empty: SQLite
  std::unique_ptr<Store> store_;
};

inline NewDocument Recipe(const std::string& id, const std::string& bytes,
                          const std::string& if_match = "") {
  NewDocument document;
  document.kind = DocumentKind::kRecipe;
  document.id = id;
  document.media_type = "text/turtle";
  document.file_name = id + ".ttl";
  document.bytes = bytes;
  document.if_match = if_match;
  return document;
}

inline LayerInfo Layer(const std::string& name, const Blob& blob) {
  LayerInfo layer;
  layer.name = name;
  layer.file_name = name + ".dat";
  layer.media_type = "application/octet-stream";
  layer.blob = blob;
  layer.facts = {{"made-by", "test"}};
  return layer;
}

inline NewVersion Version(const std::string& environment, std::vector<LayerInfo> layers,
                          const std::string& if_match = "") {
  NewVersion version;
  version.environment = environment;
  version.layers = std::move(layers);
  version.if_match = if_match;
  return version;
}

// The Error that `work` throws; a failure when it throws none.
template <typename Work>
Error ErrorOf(Work work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error was thrown";
  return Error(Code::kInternal, "none");
}

template <typename Work>
Code CodeOf(Work work) {
  return ErrorOf(std::move(work)).code();
}

template <typename Info>
std::vector<std::string> IdsOf(const std::vector<Info>& infos) {
  std::vector<std::string> ids;
  for (const Info& info : infos) ids.push_back(info.id);
  return ids;
}

}  // namespace lares::store::testing
