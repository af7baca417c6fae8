#include "base/search_path.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "base/error.h"

namespace lares {

namespace fs = std::filesystem;

std::vector<fs::path> SharePath() {
  std::vector<fs::path> folders;
  if (const char* share = std::getenv("LARES_SHARE"); share != nullptr && *share != '\0') {
    folders.emplace_back(share);
  }
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(binary.parent_path().parent_path() / "share" / "lares");
  folders.emplace_back(LARES_BUILD_SOURCE_DIR);
  return folders;
}

fs::path FindShared(const fs::path& relative) {
  std::string tried;
  for (const fs::path& folder : SharePath()) {
    std::error_code error;
    if (fs::exists(folder / relative, error)) return folder / relative;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw Error(Code::kNotFound, "'" + relative.string() + "' is in none of: " + tried)
      .WithHint("set LARES_SHARE to the folder that holds ontology/, recipes/ and robots/");
}

std::vector<fs::path> ListShared(const fs::path& relative, const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(FindShared(relative))) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace lares
