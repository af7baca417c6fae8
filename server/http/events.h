// Server-Sent Events (WHATWG HTML, "Server-sent events"): their text, written and read.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lares::http {

struct Event {
  std::string event;  // its name; empty: "message"
  std::string id;     // empty: none
  std::string data;   // may hold line breaks
};

// The event's lines with the empty one that ends it. Line breaks within name and id are dropped.
std::string FormatEvent(const Event& event);

// Cuts text that arrives in pieces into lines.
class LineReader {
 public:
  explicit LineReader(std::function<void(std::string_view)> take) : take_(std::move(take)) {}

  // Hands each whole line over, without its LF or CR LF. Throws kTooLarge for a line of more than
  // 16 MiB, and what `take` throws.
  void Feed(std::string_view piece);
  // A last line that nothing ended.
  void Finish();

 private:
  void Take(std::string_view line);

  std::function<void(std::string_view)> take_;
  std::string rest_;
};

// Reads events out of a text/event-stream that arrives in pieces; comments are passed over, an
// event that the stream's end cuts off is dropped.
class EventReader {
 public:
  explicit EventReader(std::function<void(const Event&)> take);

  void Feed(std::string_view piece) { lines_.Feed(piece); }

 private:
  void TakeLine(std::string_view line);

  std::function<void(const Event&)> take_;
  Event event_;
  bool has_data_ = false;
  LineReader lines_;
};

}  // namespace lares::http
