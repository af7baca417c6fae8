// SWI-Prolog in this process, started once. Inside this folder, and for tests.
#pragma once

#include <filesystem>

namespace lares::prolog {

// Starts Prolog from the bundled rules at the first call: no signal handlers, no init files, no
// output. Returns the Prolog signal that ends a goal whose time is over. Thread-safe; leaves no
// engine attached to the calling thread. Throws kInternal when Prolog does not start.
int StartProlog();

// What a goal throws when its time is over. Prolog throws this one anew after every catch/3.
inline constexpr const char* kDeadlineBall = "$aborted";

// Loads a Prolog file from disk into the running system, over the bundled rules. For tests.
void LoadRuleFile(const std::filesystem::path& file);

}  // namespace lares::prolog
