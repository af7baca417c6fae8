// Real input from outside the project, for tests that use it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace lares::testing {

// The folder that LARES_DATA names; empty when it is not set.
inline std::filesystem::path DataFolder() {
  const char* folder = std::getenv("LARES_DATA");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

}  // namespace lares::testing

// `path` under LARES_DATA. Without LARES_DATA the test is skipped, visibly; with it, a missing file
// is a failure.
#define LARES_REQUIRE_DATA(variable, relative)                                         \
  const std::filesystem::path variable = ::lares::testing::DataFolder() / (relative);  \
  if (::lares::testing::DataFolder().empty()) GTEST_SKIP() << "LARES_DATA is not set"; \
  ASSERT_TRUE(std::filesystem::exists(variable)) << variable << " is missing in LARES_DATA"
