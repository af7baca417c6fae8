// Large files to the server over bad links: tus 1.0, see docs/transfers.md.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "server/cli/cache.h"
#include "server/cli/remote.h"

namespace lares::cli {

struct ResumableOptions {
  bool resume = false;  // go on with what an earlier process left
  std::chrono::seconds patience{60};
  std::optional<Cache> cache = Cache::OfUser();  // where it is noted how far one came
};

// A finished upload, and the hash of the file that it is of.
struct FinishedUpload {
  std::string path;  // "/v1/uploads/…"
  std::string sha256;
};

// Sends `file`, going on where it stopped whenever the connection breaks. Throws ConnectionError
// when it stays broken, with a hint to use --resume; kIo when the server got other bytes.
FinishedUpload UploadFile(Remote& remote, const std::string& what,
                          const std::filesystem::path& file, const ResumableOptions& options);

// Once it was used: the server may forget it. Faults are none of the caller's.
void ForgetUpload(Remote& remote, const FinishedUpload& upload, const ResumableOptions& options);

}  // namespace lares::cli
