// SHA-256, the name of every blob.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace lares {

// Lower-case hexadecimal, 64 characters.
std::string Sha256Hex(std::string_view bytes);

// Of a whole file, read in pieces. Throws kIo.
std::string Sha256OfFile(const std::filesystem::path& path);

// True for 64 lower-case hexadecimal digits.
bool IsSha256Hex(std::string_view text);

// The same in pieces. Not thread-safe.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void Update(std::string_view bytes);
  // Call once; the object is spent afterwards.
  std::string FinishHex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares
