// Pictures as PNG files. The one door to libpng.
#pragma once

#include <string>

#include "mapping/picture/image.h"

namespace lares::picture {

// 8 bits a channel. Throws kInternal when the image has no pixels, or not as many as it says.
std::string ToPng(const Image& image);

}  // namespace lares::picture
