#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "server/cli/command.h"

namespace lares::cli {
namespace {

// `lares serve` in a process that a SIGTERM waits for already.
[[noreturn]] void ServeAndStop(const std::string& data) {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  ::kill(::getpid(), SIGTERM);
  const char* arguments[] = {"lares", "serve", "--port", "0", "--data", data.c_str()};
  std::exit(Run(6, arguments));
}

TEST(ServeDeathTest, ASignalStopsItCleanlyAndItSaysSo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::string data = ::testing::TempDir() + "lares_serve_" + std::to_string(::getpid());
  EXPECT_EXIT(ServeAndStop(data), ::testing::ExitedWithCode(0),
              "\"message\":\"ready\".*\n.*\"message\":\"stopping\".*\n.*\"message\":\"stopped\"");
  std::filesystem::remove_all(data);
}

}  // namespace
}  // namespace lares::cli
