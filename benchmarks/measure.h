// Times and rows of the benchmarks.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"

namespace lares::bench {

inline double SecondsOf(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double MedianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

inline double MedianOfFive(const std::function<double()>& measure) {
  std::vector<double> values;
  for (int i = 0; i < 5; ++i) values.push_back(measure());
  return MedianOf(std::move(values));
}

// What rows.sh reads: what, relation, limit, unit, measured, apart by tabs.
inline void Row(const std::string& what, const char* relation, double limit, const char* unit,
                double measured) {
  std::printf("%s\t%s\t%g\t%s\t%.6g\n", what.c_str(), relation, limit, unit, measured);
  std::fflush(stdout);
}

// A figure without a limit.
inline void Note(const std::string& what, const char* unit, double measured) {
  std::printf("%s\t-\t-\t%s\t%.6g\n", what.c_str(), unit, measured);
  std::fflush(stdout);
}

// An empty folder that is gone with its value.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_((std::filesystem::temp_directory_path() / "lares-bench-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) throw Error(Code::kIo, "no temporary folder");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace lares::bench
