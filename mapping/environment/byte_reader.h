// A file read once from front to back, in constant memory, that always knows where it is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace lares::environment {

class ByteReader {
 public:
  // Fills up to `capacity` bytes and says how many; 0 only at the end. May throw.
  using Source = std::function<std::size_t(char* into, std::size_t capacity)>;

  // `name` is what errors call the file.
  ByteReader(Source source, std::string name);
  // Throws kNotFound or kIo; reading throws kIo.
  static ByteReader OfFile(const std::filesystem::path& file, std::string name);
  // `bytes` must outlive the reader.
  static ByteReader OfBytes(std::string_view bytes, std::string name);

  // The next byte, or −1 at the end.
  int Get() {
    if (next_ == end_ && !Fill()) return -1;
    return static_cast<unsigned char>((*buffer_)[next_++]);
  }
  int Peek() {
    if (next_ == end_ && !Fill()) return -1;
    return static_cast<unsigned char>((*buffer_)[next_]);
  }
  // All `count` bytes or, with fewer left, false.
  bool Read(char* into, std::size_t count);
  // The bytes up to the next '\n' without it (nor a '\r' before it); nothing at the end. A line
  // longer than `max_bytes` is kInvalid.
  std::optional<std::string> ReadLine(std::size_t max_bytes);
  // The next non-blank run of characters; empty at the end. Longer than `max_bytes` is kInvalid.
  std::string ReadToken(std::size_t max_bytes);
  // Up to `count` of the bytes that come next, without consuming them; `count` ≤ kMaxPeek. Only
  // before anything was read.
  std::string_view PeekFront(std::size_t count);

  std::uint64_t offset() const { return consumed_ + next_; }
  const std::string& name() const { return name_; }
  // Throws kInvalid: "<name>: byte <offset>: <message>".
  [[noreturn]] void Fail(const std::string& message) const { FailAt(offset(), message); }
  [[noreturn]] void FailAt(std::uint64_t offset, const std::string& message) const;

  static constexpr std::size_t kMaxPeek = 4096;

 private:
  static constexpr std::size_t kBufferBytes = 1 << 16;
  bool Fill();

  Source source_;
  std::string name_;
  std::unique_ptr<std::array<char, kBufferBytes>> buffer_;
  std::size_t next_ = 0, end_ = 0;
  std::uint64_t consumed_ = 0;  // bytes before the buffer
};

}  // namespace lares::environment
