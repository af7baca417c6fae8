#include "server/cli/patience.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "server/cli/download.h"
#include "server/cli/remote.h"
#include "server/http/client.h"

namespace lares::cli {
namespace {

constexpr std::chrono::milliseconds kFirstPause{100};
constexpr std::chrono::milliseconds kLongestPause{2000};

}  // namespace

bool IsPassing(const std::exception& error) {
  if (dynamic_cast<const http::ConnectionError*>(&error) != nullptr) return true;
  const auto* remote = dynamic_cast<const RemoteError*>(&error);
  return remote != nullptr && (remote->problem_code() == "upload-locked" ||
                               remote->problem_code() == "request-in-progress" ||
                               remote->problem_code() == "request-timeout");
}

bool Patience::Wait() {
  const auto now = std::chrono::steady_clock::now();
  if (!waiting_) {
    waiting_ = true;
    since_ = now;
    pause_ = kFirstPause;
    if (time_.count() > 0) std::fputs("lares: the connection broke, trying again …\n", stderr);
  }
  if (now - since_ >= time_ || IsAskedToStop()) return false;
  std::this_thread::sleep_for(pause_);
  pause_ = std::min(pause_ * 2, kLongestPause);
  return !IsAskedToStop();
}

}  // namespace lares::cli
