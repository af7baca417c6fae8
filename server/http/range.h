// The Range header (RFC 9110 §14): one range of bytes, or the whole.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lares::http {

struct ByteRange {
  enum class Kind {
    kWhole,          // no range, another unit, malformed or several ranges: answered whole
    kPart,           // `offset` and `length`, length > 0
    kUnsatisfiable,  // 416
  };
  Kind kind = Kind::kWhole;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

ByteRange ParseRange(std::string_view header, std::uint64_t size);

// "bytes 0-9/100", "bytes */100".
std::string FormatContentRange(const ByteRange& range, std::uint64_t size);

}  // namespace lares::http
