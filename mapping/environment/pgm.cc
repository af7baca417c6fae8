#include "mapping/environment/pgm.h"

#include <charconv>
#include <string>

#include "mapping/environment/facts.h"
#include "mapping/environment/magic.h"

namespace lares::environment {
namespace {

bool IsBlank(int byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

void SkipBlanksAndComments(ByteReader& reader) {
  for (;;) {
    while (IsBlank(reader.Peek())) reader.Get();
    if (reader.Peek() != '#') return;
    for (int byte = reader.Get(); byte >= 0 && byte != '\n';) byte = reader.Get();
  }
}

// Decimal digits up to the next byte that is none.
std::uint32_t ReadNumber(ByteReader& reader, const char* what, std::uint32_t max) {
  SkipBlanksAndComments(reader);
  std::uint64_t number = 0;
  bool has_digits = false;
  while (reader.Peek() >= '0' && reader.Peek() <= '9') {
    number = number * 10 + static_cast<std::uint64_t>(reader.Get() - '0');
    has_digits = true;
    if (number > max) reader.Fail(std::string(what) + " is more than " + std::to_string(max));
  }
  if (!has_digits) {
    reader.Fail(std::string(reader.Peek() < 0 ? "the file ends before " : "no number for ") + what);
  }
  return static_cast<std::uint32_t>(number);
}

PgmHeader ReadHeader(ByteReader& reader) {
  constexpr std::uint32_t kMaxSide = 1'000'000;
  const std::string_view front = reader.PeekFront(512);
  const bool is_pgm = front.size() > 2 && front[0] == 'P' && (front[1] == '2' || front[1] == '5') &&
                      (IsBlank(front[2]) || front[2] == '#');
  if (!is_pgm) reader.Fail(NotA("a PGM image (P5 or P2)", front));
  PgmHeader header;
  header.is_text = front[1] == '2';
  reader.Get();
  reader.Get();
  header.width = ReadNumber(reader, "the width", kMaxSide);
  header.height = ReadNumber(reader, "the height", kMaxSide);
  if (header.width == 0 || header.height == 0) reader.Fail("the image has no pixels");
  if (std::uint64_t{header.width} * header.height > UINT32_MAX) {
    reader.Fail("the image has more than 4294967295 pixels");
  }
  header.white = ReadNumber(reader, "the largest grey value", 65535);
  if (header.white == 0) reader.Fail("the largest grey value is 0");
  if (!IsBlank(reader.Get())) reader.Fail("the header does not end in white space");
  return header;
}

}  // namespace

PgmHeader ReadPgm(ByteReader& reader, const std::function<void(double grey)>& visit) {
  const PgmHeader header = ReadHeader(reader);
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  const auto fail = [&](std::uint64_t pixel, const std::string& message) {
    reader.Fail("pixel " + std::to_string(pixel + 1) + " of " + std::to_string(pixels) + ": " +
                message);
  };
  for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) {
    std::uint32_t value = 0;
    if (header.is_text) {
      value = ReadNumber(reader, "a pixel", 65535);
    } else {
      const int bytes = header.white > 255 ? 2 : 1;
      for (int i = 0; i < bytes; ++i) {
        const int byte = reader.Get();
        if (byte < 0) fail(pixel, "the file ends");
        value = value << 8 | static_cast<std::uint32_t>(byte);
      }
    }
    if (value > header.white) fail(pixel, "brighter than the header's largest grey value");
    visit(static_cast<double>(value) / header.white);
  }
  while (IsBlank(reader.Peek())) reader.Get();
  if (reader.Peek() >= 0) reader.Fail("data follow the last pixel");
  return header;
}

}  // namespace lares::environment
