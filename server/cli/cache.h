// What was got from servers before, by its hash: ~/.cache/lares (XDG_CACHE_HOME).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace lares::cli {

// Manifests of versions and files of layers. May be removed at any time; several processes may use
// it at once. What cannot be kept there is no fault: it is got again the next time.
class Cache {
 public:
  static constexpr std::uint64_t kUsualBytes = std::uint64_t{4} << 30;

  // `folder` is made when something is kept.
  explicit Cache(std::filesystem::path folder) : folder_(std::move(folder)) {}
  // Of this user; nothing when there is neither XDG_CACHE_HOME nor HOME.
  static std::optional<Cache> OfUser();

  // A file as it was kept; its bytes are the caller's to check. Its use is noted.
  std::optional<std::filesystem::path> Find(const std::string& sha256) const;
  void Drop(const std::string& sha256) const;
  // Where a file is put together before it is kept: what is there is its beginning. Nothing when
  // another process is at it, or the folder cannot be written.
  class Partial {
   public:
    Partial(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
    ~Partial();
    Partial(Partial&& other) noexcept;
    Partial& operator=(Partial&&) = delete;
    const std::filesystem::path& path() const { return path_; }

   private:
    std::filesystem::path path_;
    int lock_;
  };
  std::optional<Partial> Begin(const std::string& sha256) const;
  // A partial that is whole and checked.
  void Keep(const Partial& partial, const std::string& sha256) const;

  // A small text by name ("versions/…", "uploads/…").
  std::optional<std::string> ReadText(const std::string& name) const;
  void KeepText(const std::string& name, const std::string& text) const;
  void DropText(const std::string& name) const;

  // Removes what was not used for longest until the files have at most `max_bytes` together; never
  // those of `in_use`.
  void Trim(std::uint64_t max_bytes, const std::set<std::string>& in_use) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace lares::cli
