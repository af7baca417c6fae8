#include "server/http/events.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace lares::http {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> Read(const std::string& text, std::size_t step) {
  std::vector<std::string> events;
  EventReader reader([&](const Event& event) {
    events.push_back(event.event + "|" + event.id + "|" + event.data);
  });
  for (std::size_t at = 0; at < text.size(); at += step) {
    reader.Feed(std::string_view(text).substr(at, step));
  }
  return events;
}

TEST(Events, AreWrittenWithALineForEachLineOfData) {
  EXPECT_EQ(FormatEvent({"change", "7", "a\nb\r\nc"}),
            "event: change\nid: 7\ndata: a\ndata: b\ndata: c\n\n");
  EXPECT_EQ(FormatEvent({"", "", ""}), "data: \n\n");
}

TEST(Events, CannotBeForgedByLineBreaksInANameOrId) {
  EXPECT_EQ(FormatEvent({"a\ndata: x", "1\r2", "y\rz"}),
            "event: adata: x\nid: 12\ndata: y\ndata: z\n\n");
}

TEST(Events, AreReadFromPiecesOfAnySize) {
  const std::string text =
      FormatEvent({"a", "1", "x\n\ny"}) + ":\n\n" + FormatEvent({"", "", " z"}) + "retry: 10\n\n";
  for (const std::size_t step : {1, 2, 3, 7, 1000}) {
    EXPECT_THAT(Read(text, step), ElementsAre("a|1|x\n\ny", "|| z")) << step;
  }
}

TEST(Events, ThatTheEndCutsOffAreDropped) {
  EXPECT_THAT(Read("event: a\ndata: x\n", 4), IsEmpty());
}

TEST(Lines, AreHandedOverWholeWithTheirEndsTakenOff) {
  std::vector<std::string> lines;
  LineReader reader([&](std::string_view line) { lines.emplace_back(line); });
  for (const char* piece : {"a", "b\n\nc\r", "\nd"}) reader.Feed(piece);
  EXPECT_THAT(lines, ElementsAre("ab", "", "c"));
  reader.Finish();
  EXPECT_THAT(lines, ElementsAre("ab", "", "c", "d"));
}

TEST(Lines, ThatNeverEndAreRefused) {
  LineReader reader([](std::string_view) {});
  const std::string piece(1 << 20, 'x');
  EXPECT_THROW(
      {
        for (int i = 0; i < 17; ++i) reader.Feed(piece);
      },
      Error);
}

}  // namespace
}  // namespace lares::http
