// xsd:dateTime, xsd:date and xsd:time (W3C XML Schema 1.1 Part 2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reasoner/sparql/decimal.h"

namespace lares::sparql {

struct DateTime {
  std::int64_t year = 1972;  // of xsd:time: any leap year
  int month = 12;
  int day = 31;
  int hour = 0;
  int minute = 0;
  Decimal second;
  std::optional<int> zone_minutes;  // east of UTC
};

// Nothing for what is malformed or no date of the calendar.
std::optional<DateTime> ParseDateTime(std::string_view text);
std::optional<DateTime> ParseDate(std::string_view text);
std::optional<DateTime> ParseTime(std::string_view text);

// -1, 0, 1; nothing when one has a zone and the other has not, and they are within 14 hours.
std::optional<int> Compare(const DateTime& a, const DateTime& b);
// A total order that agrees with Compare where that says something; no zone counts as UTC.
int CompareTotal(const DateTime& a, const DateTime& b);

std::string ZoneText(const DateTime& time);  // "Z", "-08:00", ""
std::string ZoneDuration(int zone_minutes);  // "PT0S", "-PT8H"
// The time `milliseconds` after 1970-01-01T00:00:00Z.
std::string DateTimeText(std::int64_t milliseconds);

}  // namespace lares::sparql
