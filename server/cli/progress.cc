#include "server/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr std::uint64_t kWorthShowing = 4'000'000;
constexpr int kWidth = 30;

}  // namespace

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)), visible_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputc('\n', stderr);
}

void ProgressBar::Show(std::uint64_t done, std::uint64_t total) {
  if (!visible_ || std::max(done, total) < kWorthShowing) return;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && done != total && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  if (total == 0) {
    std::fprintf(stderr, "\r%s %s ", title_.c_str(), FormatBytes(done).c_str());
    return;
  }
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const int filled = std::clamp(static_cast<int>(part * kWidth), 0, kWidth);
  std::fprintf(stderr, "\r%s [%s%s] %3.0f %% of %s ", title_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - filled), '.').c_str(), part * 100,
               FormatBytes(total).c_str());
}

}  // namespace lares::cli
