#include "server/http/events.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace lares::http {
namespace {

constexpr std::size_t kMaxLine = 16u << 20;

std::string OneLine(std::string text) {
  std::erase_if(text, [](char c) { return c == '\n' || c == '\r' || c == '\0'; });
  return text;
}

}  // namespace

std::string FormatEvent(const Event& event) {
  std::string text;
  if (!event.event.empty()) text += "event: " + OneLine(event.event) + "\n";
  if (!event.id.empty()) text += "id: " + OneLine(event.id) + "\n";
  std::string_view rest = event.data;
  while (true) {
    // A lone CR ends a line too.
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    text += "data: ";
    text += rest.substr(0, end);
    text += '\n';
    if (end == rest.size()) break;
    rest.remove_prefix(rest.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
  }
  return text + "\n";
}

void LineReader::Feed(std::string_view piece) {
  std::size_t end = 0;
  while ((end = piece.find('\n')) != std::string_view::npos) {
    if (rest_.empty()) {
      Take(piece.substr(0, end));
    } else {
      rest_ += piece.substr(0, end);
      const std::string line = std::exchange(rest_, {});
      Take(line);
    }
    piece.remove_prefix(end + 1);
  }
  if (rest_.size() + piece.size() > kMaxLine) {
    throw Error(Code::kTooLarge, "a line of the answer is longer than 16 MiB");
  }
  rest_ += piece;
}

void LineReader::Finish() {
  if (!rest_.empty()) Take(std::exchange(rest_, {}));
}

void LineReader::Take(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  take_(line);
}

EventReader::EventReader(std::function<void(const Event&)> take)
    : take_(std::move(take)), lines_([this](std::string_view line) { TakeLine(line); }) {}

void EventReader::TakeLine(std::string_view line) {
  if (line.empty()) {
    const Event event = std::exchange(event_, {});
    if (std::exchange(has_data_, false)) take_(event);
    return;
  }
  const std::size_t colon = std::min(line.find(':'), line.size());
  const std::string_view name = line.substr(0, colon);
  std::string_view value = line.substr(std::min(colon + 1, line.size()));
  if (value.starts_with(' ')) value.remove_prefix(1);
  if (name == "event") {
    event_.event = value;
  } else if (name == "id") {
    event_.id = value;
  } else if (name == "data") {
    if (event_.data.size() + value.size() > kMaxLine) {
      throw Error(Code::kTooLarge, "an event is longer than 16 MiB");
    }
    if (has_data_) event_.data += '\n';
    event_.data += value;
    has_data_ = true;
  }
}

}  // namespace lares::http
