#include "reasoner/sparql/date_time.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace lares::sparql {
namespace {

// Reads from the front of a text; once something is missing, everything is.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  void Literal(char c) {
    if (text_.empty() || text_[0] != c)
      ok_ = false;
    else
      text_.remove_prefix(1);
  }
  bool Accept(char c) {
    if (text_.empty() || text_[0] != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  std::int64_t Digits(std::size_t fewest, std::size_t most) {
    std::size_t count = 0;
    std::int64_t value = 0;
    while (count < text_.size() && count < most && text_[count] >= '0' && text_[count] <= '9') {
      value = value * 10 + (text_[count++] - '0');
    }
    ok_ = ok_ && count >= fewest;
    text_.remove_prefix(count);
    return value;
  }
  int Two() { return static_cast<int>(Digits(2, 2)); }
  // Two digits and a fraction.
  Decimal Seconds() {
    std::size_t count = 0;
    while (count < text_.size() &&
           ((text_[count] >= '0' && text_[count] <= '9') || (text_[count] == '.' && count == 2))) {
      ++count;
    }
    const auto value = ParseDecimal(text_.substr(0, count));
    ok_ = ok_ && value && count >= 2 && (count == 2 || (text_[2] == '.' && count > 3));
    text_.remove_prefix(count);
    return value.value_or(Decimal{});
  }
  std::optional<int> Zone() {
    if (text_.empty()) return std::nullopt;
    if (Accept('Z')) return 0;
    const int sign = text_[0] == '-' ? -1 : 1;
    if (!Accept('-')) Literal('+');
    const int hours = Two();
    Literal(':');
    const int minutes = Two();
    ok_ = ok_ && minutes < 60 && hours * 60 + minutes <= 14 * 60;
    return sign * (hours * 60 + minutes);
  }
  void Date(DateTime& time) {
    const bool is_negative = Accept('-');
    const std::size_t before = text_.size();
    time.year = Digits(4, 12);
    ok_ = ok_ && !(before - text_.size() > 4 && time.year < 1000);
    if (is_negative) time.year = -time.year;
    Literal('-');
    time.month = Two();
    Literal('-');
    time.day = Two();
    const std::chrono::year_month_day day{
        std::chrono::year(static_cast<int>((time.year % 400 + 400) % 400 + 2000)),
        std::chrono::month(static_cast<unsigned>(time.month)),
        std::chrono::day(static_cast<unsigned>(time.day))};
    ok_ = ok_ && day.ok();
  }
  void Time(DateTime& time) {
    time.hour = Two();
    Literal(':');
    time.minute = Two();
    Literal(':');
    time.second = Seconds();
    const bool is_midnight = time.hour == 24 && time.minute == 0 && time.second.digits == 0;
    ok_ = ok_ && (time.hour < 24 || is_midnight) && time.minute < 60 &&
          Compare(time.second, Decimal{60, 0}) < 0;
  }
  bool IsDone() const { return ok_ && text_.empty(); }

 private:
  std::string_view text_;
  bool ok_ = true;
};

// Days from 1970-01-01 in the proleptic Gregorian calendar; whole cycles of 400 years apart.
std::int64_t DayNumber(const DateTime& time) {
  const std::int64_t cycle = (time.year - 2000) / 400 - (time.year < 2000 ? 1 : 0);
  const int year = static_cast<int>(time.year - cycle * 400);
  const std::chrono::sys_days days = std::chrono::year(year) /
                                     std::chrono::month(static_cast<unsigned>(time.month)) /
                                     std::chrono::day(static_cast<unsigned>(time.day));
  return days.time_since_epoch().count() + cycle * 146097;
}

// Minutes on the timeline, as if `zone` was the zone.
std::int64_t Minutes(const DateTime& time, int zone) {
  return (DayNumber(time) * 24 + time.hour) * 60 + time.minute - zone;
}

int Order(const DateTime& a, int zone_a, const DateTime& b, int zone_b) {
  const std::int64_t x = Minutes(a, zone_a);
  const std::int64_t y = Minutes(b, zone_b);
  if (x != y) return x < y ? -1 : 1;
  return Compare(a.second, b.second);
}

}  // namespace

std::optional<DateTime> ParseDateTime(std::string_view text) {
  DateTime time;
  Reader reader(text);
  reader.Date(time);
  reader.Literal('T');
  reader.Time(time);
  time.zone_minutes = reader.Zone();
  return reader.IsDone() ? std::optional(time) : std::nullopt;
}

std::optional<DateTime> ParseDate(std::string_view text) {
  DateTime time;
  Reader reader(text);
  reader.Date(time);
  time.zone_minutes = reader.Zone();
  return reader.IsDone() ? std::optional(time) : std::nullopt;
}

std::optional<DateTime> ParseTime(std::string_view text) {
  DateTime time;
  Reader reader(text);
  reader.Time(time);
  time.zone_minutes = reader.Zone();
  return reader.IsDone() ? std::optional(time) : std::nullopt;
}

std::optional<int> Compare(const DateTime& a, const DateTime& b) {
  constexpr int kWidest = 14 * 60;
  if (a.zone_minutes.has_value() == b.zone_minutes.has_value()) return CompareTotal(a, b);
  const auto range = [](const DateTime& t, bool first) {
    return t.zone_minutes ? *t.zone_minutes : first ? kWidest : -kWidest;
  };
  const int earliest = Order(a, range(a, true), b, range(b, false));
  const int latest = Order(a, range(a, false), b, range(b, true));
  if (earliest == latest && earliest != 0) return earliest;
  return std::nullopt;
}

int CompareTotal(const DateTime& a, const DateTime& b) {
  return Order(a, a.zone_minutes.value_or(0), b, b.zone_minutes.value_or(0));
}

std::string ZoneText(const DateTime& time) {
  if (!time.zone_minutes) return "";
  if (*time.zone_minutes == 0) return "Z";
  char text[16];
  const int minutes = std::abs(*time.zone_minutes);
  std::snprintf(text, sizeof text, "%c%02d:%02d", *time.zone_minutes < 0 ? '-' : '+',
                (minutes / 60) % 100, minutes % 60);
  return text;
}

std::string ZoneDuration(int zone_minutes) {
  if (zone_minutes == 0) return "PT0S";
  const int minutes = std::abs(zone_minutes);
  std::string text = zone_minutes < 0 ? "-PT" : "PT";
  if (minutes >= 60) text += std::to_string(minutes / 60) + "H";
  if (minutes % 60 != 0) text += std::to_string(minutes % 60) + "M";
  return text;
}

std::string DateTimeText(std::int64_t milliseconds) {
  using namespace std::chrono;
  const sys_time<std::chrono::milliseconds> time{std::chrono::milliseconds(milliseconds)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const auto rest = static_cast<int>((time - day).count());
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), rest / 3600000, rest / 60000 % 60,
                rest / 1000 % 60, rest % 1000);
  return text;
}

}  // namespace lares::sparql
