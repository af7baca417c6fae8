// The manual, written from the command line itself.
#pragma once

#include <string>

#include "server/cli/command_tree.h"

namespace lares::cli {

// The page of `command` in man(7): lares(1), or lares-plan-diff(1) of one below it. `version`
// stands in its foot.
std::string ManPage(const Command& command, const std::string& version);

// "lares-plan-diff.1"
std::string ManFileName(const Command& command);

}  // namespace lares::cli
