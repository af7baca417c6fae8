#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "mapping/objects/model_meta.h"

// Any bytes: facts or an Error, nothing else.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  lares::objects::IsModelMeta(bytes);
  try {
    lares::objects::ReadModelMeta(bytes, "fuzz");
  } catch (const lares::Error&) {
  }
  return 0;
}
