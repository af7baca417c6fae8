#include "mapping/environment/trajectory_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "mapping/environment/facts.h"
#include "mapping/environment/magic.h"

namespace lares::environment {
namespace {

constexpr std::size_t kMaxLineBytes = 1024;
constexpr double kQuaternionTolerance = 1e-2;
constexpr const char* kColumns[] = {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};

using Row = std::array<double, 8>;

struct Line {
  const ByteReader& reader;
  std::uint64_t number;
  std::string_view text;

  [[noreturn]] void Fail(const std::string& message) const {
    throw Error(Code::kInvalid, message,
                Place{reader.name(), static_cast<int>(std::min<std::uint64_t>(number, INT32_MAX))});
  }
};

Row ParseRow(const Line& line) {
  Row row{};
  std::string_view rest = line.text;
  std::size_t count = 0;
  for (; !rest.empty(); rest = Trim(rest)) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    if (count == row.size()) line.Fail("a row has eight numbers; this one has more");
    const std::optional<double> number = ToNumber(word);
    if (!number || !std::isfinite(*number)) {
      line.Fail(std::string(kColumns[count]) + " is not a finite number: '" + Excerpt(word) + "'");
    }
    row[count++] = *number;
  }
  if (count < row.size()) {
    line.Fail("a row has eight numbers (timestamp tx ty tz qx qy qz qw); this one has " +
              std::to_string(count));
  }
  return row;
}

void CheckQuaternion(const Line& line, const Row& row) {
  const double length =
      std::sqrt(row[4] * row[4] + row[5] * row[5] + row[6] * row[6] + row[7] * row[7]);
  if (!(std::abs(length - 1) <= kQuaternionTolerance)) {
    line.Fail("the quaternion's length is " + ToText(length) + ", not 1");
  }
}

std::string ToSeconds(double time_s) {
  char text[400];
  std::snprintf(text, sizeof text, "%.4f", time_s);
  return text;
}

}  // namespace

LayerFacts CheckTrajectory(ByteReader& reader) {
  const std::string front(reader.PeekFront(512));
  if (front.empty() || !LooksLike(front).empty()) reader.Fail(NotA("a TUM trajectory", front));
  BoundsBuilder bounds;
  std::uint64_t poses = 0;
  double length_m = 0;
  Row first{}, last{};
  for (std::uint64_t number = 1;; ++number) {
    const std::optional<std::string> text = reader.ReadLine(kMaxLineBytes);
    if (!text) break;
    const Line line{reader, number, Trim(*text)};
    if (line.text.empty() || line.text[0] == '#') continue;
    const Row row = ParseRow(line);
    CheckQuaternion(line, row);
    if (poses == 0) first = row;
    if (poses > 0 && !(row[0] > last[0])) line.Fail("the time does not rise");
    if (poses > 0) length_m += std::hypot(row[1] - last[1], row[2] - last[2], row[3] - last[3]);
    bounds.Add(row[1], row[2], row[3]);
    last = row;
    ++poses;
  }
  if (poses == 0) reader.Fail("there is no pose in it");

  LayerFacts facts;
  facts.media_type = "text/plain";
  facts.facts = {{"poses", std::to_string(poses)},
                 {"start_s", ToSeconds(first[0])},
                 {"duration_s", ToText(last[0] - first[0])},
                 {"length_m", ToText(length_m)}};
  facts.bounds_m = bounds.bounds_m();
  return facts;
}

}  // namespace lares::environment
