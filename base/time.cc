#include "base/time.h"

#include <cstdio>
#include <ctime>

namespace lares {

using std::chrono::milliseconds;

Time Now() { return std::chrono::time_point_cast<milliseconds>(std::chrono::system_clock::now()); }

std::string ToRfc3339(Time time) {
  const auto second = std::chrono::floor<std::chrono::seconds>(time);
  const std::time_t seconds = second.time_since_epoch().count();
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", utc.tm_year + 1900,
                utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec,
                static_cast<int>((time - second).count()));
  return text;
}

std::optional<Time> FromRfc3339(std::string_view text) {
  const std::string copy(text.substr(0, 40));
  std::tm utc{};
  int read = 0;
  if (std::sscanf(copy.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d%n", &utc.tm_year, &utc.tm_mon,
                  &utc.tm_mday, &utc.tm_hour, &utc.tm_min, &utc.tm_sec, &read) != 6) {
    return std::nullopt;
  }
  int millis = 0;
  std::size_t at = static_cast<std::size_t>(read);
  if (at < copy.size() && copy[at] == '.') {
    ++at;
    int weight = 100;
    while (at < copy.size() && copy[at] >= '0' && copy[at] <= '9') {
      millis += (copy[at] - '0') * weight;
      weight /= 10;
      ++at;
    }
  }
  if (copy.substr(at) != "Z" && copy.substr(at) != "+00:00") return std::nullopt;
  utc.tm_year -= 1900;
  utc.tm_mon -= 1;
  const bool in_range = utc.tm_mon >= 0 && utc.tm_mon < 12 && utc.tm_mday >= 1 &&
                        utc.tm_mday <= 31 && utc.tm_hour < 24 && utc.tm_min < 60 &&
                        utc.tm_sec <= 60;
  if (!in_range) return std::nullopt;
  return Time(std::chrono::seconds(::timegm(&utc)) + milliseconds(millis));
}

std::string ToAge(Time then, Time now) {
  const long long seconds = std::chrono::duration_cast<std::chrono::seconds>(now - then).count();
  if (seconds < 5) return "just now";
  struct Unit {
    long long size_s;
    const char* name;
  };
  constexpr Unit kUnits[] = {
      {31557600, "year"}, {86400, "day"}, {3600, "hour"}, {60, "minute"}, {1, "second"}};
  for (const Unit& unit : kUnits) {
    const long long count = seconds / unit.size_s;
    if (count >= 1) {
      return std::to_string(count) + ' ' + unit.name + (count > 1 ? "s ago" : " ago");
    }
  }
  return "just now";
}

}  // namespace lares
