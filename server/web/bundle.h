// Files that are part of the binary, so that it runs from any folder.
#pragma once

#include <string_view>

namespace lares::web {

// Throws kInternal for a name that is not bundled.
std::string_view Bundled(std::string_view name);

}  // namespace lares::web
