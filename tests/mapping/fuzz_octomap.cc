#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "mapping/environment/octomap_format.h"

// Any bytes: facts or an Error, nothing else.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  auto reader = lares::environment::ByteReader::OfBytes(bytes, "fuzz");
  try {
    lares::environment::CheckOctomap(reader);
  } catch (const lares::Error&) {
  }
  return 0;
}
