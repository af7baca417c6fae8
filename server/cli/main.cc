#include "server/cli/command.h"

int main(int argc, char** argv) { return lares::cli::Run(argc, argv); }
