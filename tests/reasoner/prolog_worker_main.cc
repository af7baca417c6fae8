// The test program, which is also the program of its workers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "reasoner/prolog_worker/worker_main.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == lares::prolog::kWorkerCommand) {
    lares::prolog::RunWorker();
  }
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
