// Uncompressed tar archives, read entry by entry. The one door to libarchive for reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace lares::environment {

struct TarEntry {
  std::string path;  // normalised: relative, without "." and ".."
  std::uint64_t size = 0;
};

// Files only: folders and AppleDouble companions ("._x") are passed over. Every fault is kInvalid:
// no tar, a cut-off archive, more than 64 entries, a link, device or sparse file, a path that is
// absolute or climbs with "..".
class TarReader {
 public:
  static TarReader OfFile(const std::filesystem::path& file, std::string name);
  // `bytes` must outlive the reader.
  static TarReader OfBytes(std::string_view bytes, std::string name);

  // The next file; nothing at the end.
  std::optional<TarEntry> Next();
  // Up to `capacity` bytes of the current file; 0 at its end.
  std::size_t Read(char* into, std::size_t capacity);

 private:
  struct State;
  explicit TarReader(std::shared_ptr<State> state) : state_(std::move(state)) {}
  std::shared_ptr<State> state_;
};

}  // namespace lares::environment
