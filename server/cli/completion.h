// Scripts that make a shell complete the command line.
#pragma once

#include <string>

#include "server/cli/command_tree.h"

namespace lares::cli {

// Each needs nothing but the shell itself, and completes commands, options, their values where
// these are a fixed set, files and folders.
std::string BashCompletion(const Command& root);
std::string ZshCompletion(const Command& root);
std::string FishCompletion(const Command& root);

}  // namespace lares::cli
