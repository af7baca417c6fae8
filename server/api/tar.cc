#include "server/api/tar.h"

#include <cstdio>
#include <cstring>

#include "base/error.h"

namespace lares::api {
namespace {

constexpr std::uint64_t kBlock = 512;
constexpr std::uint64_t kMaxOctal = (std::uint64_t{1} << 33) - 1;  // eleven octal digits

// The fields as POSIX.1-1988 lays them out.
struct Header {
  char name[100];
  char mode[8];
  char uid[8];
  char gid[8];
  char size[12];
  char modified[12];
  char checksum[8];
  char type;
  char link[100];
  char magic[8];  // with the version
  char user[32];
  char group[32];
  char device[16];
  char prefix[155];
  char padding[12];
};
static_assert(sizeof(Header) == kBlock);

void WriteSize(std::uint64_t size, char (&field)[12]) {
  if (size <= kMaxOctal) {
    std::snprintf(field, sizeof field, "%011llo", static_cast<unsigned long long>(size));
    return;
  }
  field[0] = static_cast<char>(0x80);
  for (int i = 11; i > 0; --i, size >>= 8) field[i] = static_cast<char>(size & 0xff);
}

}  // namespace

std::string TarHeader(std::string_view name, std::uint64_t size, Time modified) {
  Header header{};
  if (name.empty() || name.size() > sizeof header.name) {
    throw Error(Code::kInvalid, "'" + std::string(name) + "' is no name for a file in a tar");
  }
  std::memcpy(header.name, name.data(), name.size());
  std::memcpy(header.mode, "0000644", 7);
  std::memcpy(header.uid, "0000000", 7);
  std::memcpy(header.gid, "0000000", 7);
  WriteSize(size, header.size);
  const auto seconds = std::chrono::floor<std::chrono::seconds>(modified).time_since_epoch();
  WriteSize(static_cast<std::uint64_t>(std::max<std::int64_t>(seconds.count(), 0)),
            header.modified);
  header.type = '0';
  std::memcpy(header.magic, "ustar\00000", 8);
  std::memset(header.checksum, ' ', sizeof header.checksum);
  unsigned sum = 0;
  for (std::size_t i = 0; i < sizeof header; ++i) {
    sum += reinterpret_cast<const unsigned char*>(&header)[i];
  }
  std::snprintf(header.checksum, sizeof header.checksum, "%06o", sum);
  return {reinterpret_cast<const char*>(&header), sizeof header};
}

std::string TarPadding(std::uint64_t size) {
  return std::string((kBlock - size % kBlock) % kBlock, '\0');
}

std::string TarEnd() { return std::string(2 * kBlock, '\0'); }

std::uint64_t TarEntrySize(std::uint64_t size) {
  return kBlock + size + (kBlock - size % kBlock) % kBlock;
}

}  // namespace lares::api
