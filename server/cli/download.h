// Files of the server that arrive whole, in a folder that appears whole.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "server/cli/cache.h"
#include "server/cli/remote.h"

namespace lares::cli {

// While it lives, the first SIGINT or SIGTERM ends the download under way with an Error (kIo), so
// that temporary folders are removed; a second one ends the process. One at a time.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
};

bool IsAskedToStop();

struct Wanted {
  std::string what;  // for people: "layer grid"
  std::string path;  // of the request, percent-encoded
  std::multimap<std::string, std::string> query;
  std::string sha256;
};

struct Getting {
  std::optional<Cache> cache = Cache::OfUser();
  std::chrono::seconds patience{60};  // with a connection that breaks
};

// Into `file`, from the cache or with a progress bar from the server; what breaks goes on where it
// stopped, now or in the next call. Throws kIo when what arrives has another hash.
void Download(Remote& remote, const Wanted& wanted, const std::filesystem::path& file,
              const Getting& getting = {});

// False when the copy has another hash. Throws kIo. The copy is synced.
bool CopyChecked(const std::filesystem::path& from, const std::filesystem::path& to,
                 const std::string& sha256);

// Layers as `environment get` keeps them: the file's (or for a grid, unpacked, the folder's) name
// below `folder`. `layer` has name, file_name, media_type and sha256; `version_path` is that of the
// environment's version.
std::string SaveLayer(Remote& remote, const std::string& version_path, const Json& layer,
                      const std::filesystem::path& folder, const Getting& getting = {});
// The same from the cache alone. Throws kNotFound when it is not there whole.
std::string SaveCachedLayer(const Cache& cache, const Json& layer,
                            const std::filesystem::path& folder);

// A folder named on the command line, absolute and without a slash at its end.
std::filesystem::path TargetFolder(const std::string& out);

// The finished folder `temporary`/content takes the place of `out` in one step: at every moment
// there is the old one or the new one.
void PublishFolder(const std::filesystem::path& temporary, const std::filesystem::path& out);

}  // namespace lares::cli
