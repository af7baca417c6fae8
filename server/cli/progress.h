// A bar on standard error while much is sent or received, only for people who watch.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lares::cli {

class ProgressBar {
 public:
  explicit ProgressBar(std::string title);
  ~ProgressBar();  // ends the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // `total` 0: not known. Draws ten times a second at most, for more than 4 MB, on a terminal.
  void Show(std::uint64_t done, std::uint64_t total);

 private:
  std::string title_;
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace lares::cli
