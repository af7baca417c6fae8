// What the files of a downloaded environment are called.
#pragma once

#include <string>
#include <string_view>

namespace lares::api {

inline constexpr const char* kManifestFile = "manifest.json";

// "semantic.owl", "octomap.bt", "grid.tar", …: the layer's name with the extension that its file
// was uploaded with, or that its media type usually has.
std::string LayerFileName(std::string_view layer, std::string_view uploaded_as,
                          std::string_view media_type);

}  // namespace lares::api
