// Files of the server that arrive whole, in a folder that appears whole.
#pragma once

#include <filesystem>
#include <map>
#include <string>

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

struct Wanted {
  std::string what;  // for people: "layer grid"
  std::string path;  // of the request, percent-encoded
  std::multimap<std::string, std::string> query;
  std::string sha256;
};

// Streams it into `file` with a progress bar. Throws kIo when what arrives has another hash.
void Download(Remote& remote, const Wanted& wanted, const std::filesystem::path& file);

// Layers as `environment get` keeps them: the file's (or for a grid, unpacked, the folder's) name
// below `folder`. `layer` has name, file_name, media_type and sha256; `version_path` is that of the
// environment's version.
std::string SaveLayer(Remote& remote, const std::string& version_path, const Json& layer,
                      const std::filesystem::path& folder);

// A folder named on the command line, absolute and without a slash at its end.
std::filesystem::path TargetFolder(const std::string& out);

// The finished folder `temporary`/content takes the place of `out` in one step.
void PublishFolder(const std::filesystem::path& temporary, const std::filesystem::path& out);

}  // namespace lares::cli
