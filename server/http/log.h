// The server's log: one JSON object a line, on standard error.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lares::http {

enum class LogLevel { kDebug, kInfo, kWarning, kError, kOff };

using LogValue = std::variant<std::string, double, std::int64_t>;
using LogFields = std::vector<std::pair<std::string_view, LogValue>>;

// {"time":"…","level":"info","message":"…", fields…}. Bytes that are no UTF-8 are replaced.
std::string FormatLogLine(LogLevel level, std::string_view message, const LogFields& fields);

// Thread-safe; a line is written whole.
void Log(LogLevel level, std::string_view message, const LogFields& fields = {});
void SetLogLevel(LogLevel level);
// "debug", "info", "warning", "error", "off"; throws kInvalid.
LogLevel ParseLogLevel(std::string_view name);

}  // namespace lares::http
