#include "robots/urdf/reading.h"

#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "base/text.h"

namespace lares::urdf {
namespace {

constexpr double kGreatest = 1e15;
constexpr double kSmallest = 1e-200;
constexpr std::size_t kLongestName = 256;
constexpr std::size_t kMostFindings = 200;
constexpr const char* kSpaces = " \t\r\n";

std::string Shown(std::string_view text) {
  return "'" + std::string(text.substr(0, 40)) + (text.size() > 40 ? "…'" : "'");
}

std::vector<std::string_view> Words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(kSpaces, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace

void Reading::Add(Finding::Severity severity, std::string code, int line, std::string message,
                  std::string remedy) {
  if (findings_.size() >= kMostFindings) return;
  findings_.push_back(
      {severity, std::move(code), {source_, line, 0}, std::move(message), std::move(remedy)});
}

std::optional<double> Reading::Number(std::string_view text, const std::string& what, int line) {
  const auto number = ToNumber(Trim(text));
  if (!number) {
    Fault("no-number", line, what + " is no number: " + Shown(text));
    return std::nullopt;
  }
  if (!std::isfinite(*number) || std::abs(*number) > kGreatest) {
    Fault("no-number", line, what + " is no finite number of any use: " + Shown(text));
    return std::nullopt;
  }
  return std::abs(*number) < kSmallest ? 0.0 : *number;
}

std::optional<double> Reading::Attribute(const Element& element, std::string_view attribute) {
  const std::string* text = element.Find(attribute);
  if (text == nullptr) return std::nullopt;
  return Number(*text, "attribute '" + std::string(attribute) + "' of <" + element.name + ">",
                element.line);
}

template <std::size_t N>
std::optional<std::array<double, N>> Reading::Numbers(std::string_view text,
                                                      const std::string& what, int line) {
  const std::vector<std::string_view> words = Words(text);
  if (words.size() != N) {
    Fault("no-number", line,
          what + " must be " + std::to_string(N) + " numbers, not " + Shown(text));
    return std::nullopt;
  }
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto number = Number(words[i], what, line);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

std::optional<std::array<double, 3>> Reading::Vector(const Element& element,
                                                     std::string_view attribute) {
  const std::string* text = element.Find(attribute);
  if (text == nullptr) return std::nullopt;
  return Numbers<3>(*text, "attribute '" + std::string(attribute) + "' of <" + element.name + ">",
                    element.line);
}

std::optional<double> Reading::ChildNumber(const Element& element, std::string_view child) {
  const Element* found = element.Child(child);
  if (found == nullptr) return std::nullopt;
  // Old files write <update_rate value="5"/>.
  const std::string* value = found->Find("value");
  return Number(value != nullptr ? *value : found->text, "<" + std::string(child) + ">",
                found->line);
}

RawPose Reading::Origin(const Element& element) {
  RawPose pose;
  const Element* origin = element.Child("origin");
  if (origin == nullptr) return pose;
  if (const auto xyz = Vector(*origin, "xyz")) pose.xyz_m = *xyz;
  if (const auto rpy = Vector(*origin, "rpy")) pose.rpy_rad = *rpy;
  return pose;
}

RawPose Reading::PoseText(const Element& element) {
  RawPose pose;
  const auto numbers = Numbers<6>(element.text, "<" + element.name + ">", element.line);
  if (!numbers) return pose;
  std::copy_n(numbers->begin(), 3, pose.xyz_m.begin());
  std::copy_n(numbers->begin() + 3, 3, pose.rpy_rad.begin());
  return pose;
}

std::optional<std::array<double, 2>> Reading::Pair(const Element& element) {
  return Numbers<2>(element.text, "<" + element.name + ">", element.line);
}

std::string Reading::Name(const Element& element, std::string_view attribute,
                          const std::string& of) {
  const std::string* name = element.Find(attribute);
  if (name == nullptr || Trim(*name).empty()) {
    Fault("no-name", element.line, of + " has no attribute '" + std::string(attribute) + "'");
    return "";
  }
  const bool has_controls =
      std::any_of(name->begin(), name->end(), [](unsigned char c) { return c < 32 || c == 127; });
  if (name->size() > kLongestName || has_controls) {
    Fault("no-name", element.line,
          "the name " + Shown(*name) + " is longer than 256 bytes or has control characters");
    return "";
  }
  return *name;
}

}  // namespace lares::urdf
