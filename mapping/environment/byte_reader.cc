#include "mapping/environment/byte_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/error.h"

namespace lares::environment {
namespace {

bool IsBlank(int byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

}  // namespace

ByteReader::ByteReader(Source source, std::string name)
    : source_(std::move(source)),
      name_(std::move(name)),
      buffer_(std::make_unique<std::array<char, kBufferBytes>>()) {}

ByteReader ByteReader::OfFile(const std::filesystem::path& file, std::string name) {
  const std::shared_ptr<std::FILE> handle(std::fopen(file.c_str(), "rb"), [](std::FILE* opened) {
    if (opened != nullptr) std::fclose(opened);
  });
  if (handle == nullptr) {
    throw Error(errno == ENOENT ? Code::kNotFound : Code::kIo,
                "cannot open '" + file.string() + "': " + std::strerror(errno));
  }
  auto read = [handle, file](char* into, std::size_t capacity) {
    const std::size_t count = std::fread(into, 1, capacity, handle.get());
    if (count == 0 && std::ferror(handle.get()) != 0) {
      throw Error(Code::kIo, "cannot read '" + file.string() + "': " + std::strerror(errno));
    }
    return count;
  };
  return ByteReader(read, std::move(name));
}

ByteReader ByteReader::OfBytes(std::string_view bytes, std::string name) {
  auto read = [bytes](char* into, std::size_t capacity) mutable {
    const std::size_t count = bytes.copy(into, capacity);
    bytes.remove_prefix(count);
    return count;
  };
  return ByteReader(read, std::move(name));
}

bool ByteReader::Fill() {
  consumed_ += end_;
  next_ = 0;
  end_ = source_(buffer_->data(), buffer_->size());
  return end_ > 0;
}

bool ByteReader::Read(char* into, std::size_t count) {
  while (count > 0) {
    if (next_ == end_ && !Fill()) return false;
    const std::size_t piece = std::min(count, end_ - next_);
    std::copy_n(buffer_->data() + next_, piece, into);
    next_ += piece;
    into += piece;
    count -= piece;
  }
  return true;
}

std::optional<std::string> ByteReader::ReadLine(std::size_t max_bytes) {
  if (Peek() < 0) return std::nullopt;
  std::string line;
  for (int byte = Get(); byte >= 0 && byte != '\n'; byte = Get()) {
    if (line.size() == max_bytes) {
      Fail("a line is longer than " + std::to_string(max_bytes) + " bytes");
    }
    line += static_cast<char>(byte);
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

std::string ByteReader::ReadToken(std::size_t max_bytes) {
  while (IsBlank(Peek())) Get();
  std::string token;
  for (int byte = Peek(); byte >= 0 && !IsBlank(byte); byte = Peek()) {
    if (token.size() == max_bytes) {
      Fail("a word is longer than " + std::to_string(max_bytes) + " bytes");
    }
    token += static_cast<char>(Get());
  }
  return token;
}

std::string_view ByteReader::PeekFront(std::size_t count) {
  while (end_ < count && end_ < kMaxPeek) {
    const std::size_t more = source_(buffer_->data() + end_, buffer_->size() - end_);
    if (more == 0) break;
    end_ += more;
  }
  return {buffer_->data() + next_, std::min(count, end_ - next_)};
}

void ByteReader::FailAt(std::uint64_t offset, const std::string& message) const {
  throw Error(Code::kInvalid, "byte " + std::to_string(offset) + ": " + message, Place{name_});
}

}  // namespace lares::environment
