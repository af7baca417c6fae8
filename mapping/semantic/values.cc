#include "mapping/semantic/values.h"

#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"

namespace lares::semantic {
namespace {

std::optional<Time> FromUnixSeconds(std::string_view text) {
  constexpr double kMaxSeconds = 1e11;  // the year 5138
  const std::optional<double> seconds = ToNumber(text);
  if (!seconds || !(std::abs(*seconds) < kMaxSeconds)) return std::nullopt;
  return Time(std::chrono::milliseconds(std::llround(*seconds * 1000)));
}

std::optional<int> TwoDigits(std::string_view text) {
  if (text.size() != 2 || text[0] < '0' || text[0] > '9' || text[1] < '0' || text[1] > '9') {
    return std::nullopt;
  }
  return (text[0] - '0') * 10 + (text[1] - '0');
}

// XML Schema's dateTime: with "Z", an offset "+02:00", or neither.
std::optional<Time> FromDateTime(std::string_view text) {
  const std::size_t t = text.find('T');
  if (t == std::string_view::npos) return std::nullopt;
  if (text.ends_with('Z')) return FromRfc3339(text);
  const std::size_t sign = text.find_first_of("+-", t);
  std::chrono::minutes offset{0};
  if (sign != std::string_view::npos) {
    const std::string_view zone = text.substr(sign + 1);
    const auto hours = TwoDigits(zone.substr(0, 2));
    const auto minutes =
        zone.size() == 5 && zone[2] == ':' ? TwoDigits(zone.substr(3)) : std::nullopt;
    if (!hours || !minutes) return std::nullopt;
    offset = std::chrono::hours(*hours) + std::chrono::minutes(*minutes);
    if (text[sign] == '-') offset = -offset;
  }
  const std::optional<Time> local = FromRfc3339(std::string(text.substr(0, sign)) + "Z");
  return local ? std::optional<Time>(*local - offset) : std::nullopt;
}

}  // namespace

std::string Quoted(const rdf::View& view, rdf::TermId term) {
  if (view.dictionary().Get(term).kind == rdf::TermKind::kIri) {
    return "<" + view.AsWritten(term) + ">";
  }
  return rdf::ToNTriples(view.dictionary().Get(term));
}

std::optional<double> FindNumber(const rdf::View& view, const std::vector<rdf::TermId>& subjects,
                                 rdf::TermId property, const std::string& name) {
  std::optional<double> found;
  for (const rdf::TermId subject : subjects) {
    for (const rdf::TermId value : view.Objects(subject, property)) {
      const rdf::TermView term = view.dictionary().Get(value);
      const std::optional<double> number =
          term.kind == rdf::TermKind::kLiteral ? ToNumber(Trim(term.value)) : std::nullopt;
      const auto fail = [&](const std::string& what) {
        throw Error(Code::kInvalid, Quoted(view, subject) + ": " + name + what);
      };
      if (!number || !std::isfinite(*number)) {
        fail(" is not a finite number: " + rdf::ToNTriples(term).substr(0, 80));
      }
      if (found && *found != *number) fail(" has two different values");
      found = number;
    }
  }
  return found;
}

std::optional<Time> ToTime(const rdf::TermView& term) {
  const std::string_view text = Trim(term.value);
  if (term.kind == rdf::TermKind::kLiteral) {
    const std::optional<Time> time = FromDateTime(text);
    return time ? time : FromUnixSeconds(text);
  }
  const std::size_t underscore = text.find_last_of('_');
  if (underscore == std::string_view::npos) return std::nullopt;
  return FromUnixSeconds(text.substr(underscore + 1));
}

}  // namespace lares::semantic
