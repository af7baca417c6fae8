#include "mapping/picture/png.h"

#include <png.h>

#include "base/error.h"

namespace lares::picture {

std::string ToPng(const Image& image) {
  if (image.pixels.empty() ||
      image.pixels.size() != static_cast<std::size_t>(image.width) * image.height) {
    throw Error(Code::kInternal, "a picture of another size than it says");
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) ==
      0) {
    throw Error(Code::kInternal, std::string("a picture cannot be written: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace lares::picture
