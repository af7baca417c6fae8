#include "server/http/header_check.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "base/text.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

constexpr std::string_view kLineEnd = "\r\n";
constexpr int kMaxSizeDigits = 15;
constexpr int kMaxExtensionBytes = 256;

[[noreturn]] void Refuse(const std::string& why) { throw ProblemError("bad-request", why); }

bool IsTokenChar(char c) {
  static constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         kMarks.find(c) != std::string_view::npos;
}

bool IsControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t') || byte == 0x7f;
}

struct Framing {
  bool chunked = false;
  bool length = false;
};

void CheckLength(std::string_view value, Framing& framing) {
  if (framing.length) Refuse("the request states the length of its body twice");
  if (value.empty() || value.size() > 18 ||
      value.find_first_not_of("0123456789") != std::string_view::npos) {
    Refuse("Content-Length is no number");
  }
  framing.length = true;
}

void CheckEncoding(std::string_view value, Framing& framing) {
  if (framing.chunked || ToLower(value) != "chunked") {
    Refuse("the only Transfer-Encoding taken is chunked, once");
  }
  framing.chunked = true;
}

void CheckField(std::string_view line, Framing& framing) {
  const std::size_t colon = line.find(':');
  const std::string_view name = line.substr(0, colon);
  if (colon == std::string_view::npos || name.empty() ||
      !std::all_of(name.begin(), name.end(), IsTokenChar)) {
    Refuse("a header field cannot be read: its name must be a token, directly before its colon");
  }
  const std::string_view value = Trim(line.substr(colon + 1));
  const std::string lowered = ToLower(name);
  if (lowered == "content-length") CheckLength(value, framing);
  if (lowered == "origin" && value.empty()) Refuse("an Origin header has a value");
  if (lowered == "transfer-encoding") CheckEncoding(value, framing);
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

void CheckRawHeader(std::string_view header) {
  Framing framing;
  for (bool first = true; !header.empty(); first = false) {
    const std::size_t end = header.find(kLineEnd);
    const std::string_view line = header.substr(0, end);
    if (end == std::string_view::npos || std::any_of(line.begin(), line.end(), IsControl)) {
      Refuse("the request's header holds a control character");
    }
    header.remove_prefix(end + kLineEnd.size());
    if (line.empty() && header.empty()) break;
    if (!first) CheckField(line, framing);
  }
  if (framing.chunked && framing.length) Refuse("the request states the length of its body twice");
}

std::size_t AwaitedLength(std::string_view header) {
  static constexpr std::string_view kLength = "\r\ncontent-length:";
  const std::string lowered = ToLower(header);
  const std::size_t at = lowered.find(kLength);
  if (at == std::string::npos || lowered.find("\r\nexpect:") != std::string::npos) return 0;
  const std::size_t from = at + kLength.size();
  const std::string_view value =
      Trim(std::string_view(lowered).substr(from, lowered.find("\r\n", from) - from));
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), length);
  return error == std::errc() && end == value.data() + value.size() ? length : 0;
}

bool ChunkedBodyCheck::Accept(std::string_view bytes) {
  while (!bytes.empty() && !refused_) {
    if (stage_ == Stage::kData) {
      const std::uint64_t taken = std::min<std::uint64_t>(size_, bytes.size());
      bytes.remove_prefix(static_cast<std::size_t>(taken));
      size_ -= taken;
      if (size_ == 0) stage_ = Stage::kDataCr;
      continue;
    }
    refused_ = !AcceptByte(bytes.front());
    bytes.remove_prefix(1);
  }
  return !refused_;
}

bool ChunkedBodyCheck::AcceptByte(char byte) {
  const auto expect = [&](char wanted, Stage next) {
    stage_ = next;
    return byte == wanted;
  };
  switch (stage_) {
    case Stage::kSize:
      return AcceptSize(byte);
    case Stage::kExtension:
      if (byte == '\r') return expect('\r', Stage::kSizeEnd);
      return !IsControl(byte) && ++extension_bytes_ <= kMaxExtensionBytes;
    case Stage::kSizeEnd:
      return expect('\n', size_ == 0 ? Stage::kLastCr : Stage::kData);
    case Stage::kDataCr:
      return expect('\r', Stage::kDataLf);
    case Stage::kDataLf:
      digits_ = extension_bytes_ = 0;
      size_ = 0;
      return expect('\n', Stage::kSize);
    case Stage::kLastCr:
      return expect('\r', Stage::kLastLf);
    case Stage::kLastLf:
      return expect('\n', Stage::kEnd);
    case Stage::kData:
    case Stage::kEnd:
      break;
  }
  return false;
}

bool ChunkedBodyCheck::AcceptSize(char byte) {
  if (const int digit = HexDigit(byte); digit >= 0) {
    size_ = size_ * 16 + static_cast<std::uint64_t>(digit);
    return ++digits_ <= kMaxSizeDigits;
  }
  if (digits_ == 0) return false;
  stage_ = byte == ';' ? Stage::kExtension : Stage::kSizeEnd;
  return byte == ';' || byte == '\r';
}

}  // namespace lares::http
