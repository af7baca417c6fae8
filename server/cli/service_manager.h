// What systemd is told about this process, when it started it (Type=notify).
#pragma once

#include <string>

namespace lares::cli {

// Sends "READY=1" and the like to $NOTIFY_SOCKET; false when nobody listens there, which is no
// fault.
bool TellServiceManager(const std::string& state);

}  // namespace lares::cli
