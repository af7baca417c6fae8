// The command line against a real server.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "server/cli/command.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

class CliTest : public ApiTest {
 protected:
  // A cache of this test's own.
  CliTest() { ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1); }

  Outcome Lares(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "lares");
    arguments.insert(arguments.end(), {"--server", url_.empty() ? server_->url() : url_});
    std::vector<const char*> raw;
    for (const std::string& argument : arguments) raw.push_back(argument.c_str());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = cli::Run(static_cast<int>(raw.size()), raw.data());
    outcome.out = ::testing::internal::GetCapturedStdout();
    outcome.err = ::testing::internal::GetCapturedStderr();
    return outcome;
  }

  std::string url_;
};

}  // namespace lares::testing
