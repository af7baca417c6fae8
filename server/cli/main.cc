#include <string_view>

#include "reasoner/prolog_worker/worker_main.h"
#include "server/cli/command.h"

// The server runs this program again for each goal from outside.
int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == lares::prolog::kWorkerCommand) {
    lares::prolog::RunWorker();
  }
  return lares::cli::Run(argc, argv);
}
