// The rule modules, compiled and embedded.
#pragma once

#include <span>

namespace lares::prolog {

// A saved state for PL_set_resource_db_mem.
std::span<const unsigned char> BundledRules();

}  // namespace lares::prolog
