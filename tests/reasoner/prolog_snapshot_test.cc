// Views as files in memory.
#include <sys/mman.h>
#include <unistd.h>

#include "base/error.h"
#include "reasoner/prolog_worker/snapshot_file.h"
#include "tests/reasoner/prolog_worker_fixture.h"

namespace lares::prolog::testing {
namespace {

std::vector<std::string> Statements(const rdf::View& view) {
  std::vector<std::string> statements;
  const auto text = [&](rdf::TermId id) {
    const rdf::TermView term = view.dictionary().Get(id);
    return std::to_string(static_cast<int>(term.kind)) + std::string(term.value) + "^" +
           std::string(term.datatype) + "@" + std::string(term.language);
  };
  view.ForEach({}, [&](const rdf::Triple& triple) {
    std::string statement =
        text(triple.subject) + " " + text(triple.predicate) + " " + text(triple.object);
    for (const std::string& graph : view.GraphsOf(triple)) statement += " " + graph;
    statements.push_back(std::move(statement));
    return true;
  });
  std::sort(statements.begin(), statements.end());
  return statements;
}

TEST(SnapshotFileTest, HoldsAllThatTheViewDoes) {
  rdf::View view = Kitchen();
  for (int i = 0; i < 100; ++i) view.dictionary().InternIri("http://unused/" + std::to_string(i));
  view = With(view, "recipe:serve", {{Named("cup1"), Named("on"), Named("tray")}});
  const SnapshotFile file(view);
  const rdf::View read = ReadSnapshot(file.fd());
  EXPECT_EQ(Statements(read), Statements(view));
  EXPECT_EQ(Statements(read).size(), 6u);
  EXPECT_LT(read.dictionary().size(), 15u);
}

TEST(SnapshotFileTest, OfNothingIsNothing) {
  EXPECT_EQ(ReadSnapshot(SnapshotFile(EmptyView()).fd()).size(), 0u);
}

TEST(SnapshotFileTest, CannotBeChanged) {
  const SnapshotFile file(Kitchen());
  EXPECT_LT(::pwrite(file.fd(), "x", 1, 0), 0);
  EXPECT_NE(::ftruncate(file.fd(), 0), 0);
}

TEST(SnapshotFileTest, CutShortOrDamagedIsRefused) {
  const SnapshotFile file(Kitchen());
  std::string bytes(file.size(), '\0');
  ASSERT_EQ(::pread(file.fd(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  const auto read = [](const std::string& content) {
    const int fd = ::memfd_create("damaged", MFD_CLOEXEC);
    EXPECT_EQ(::write(fd, content.data(), content.size()), static_cast<ssize_t>(content.size()));
    try {
      ReadSnapshot(fd);
    } catch (...) {
      ::close(fd);
      throw;
    }
    ::close(fd);
  };
  EXPECT_NO_THROW(read(bytes));
  for (std::size_t size = 1; size < bytes.size(); size += 7) {
    EXPECT_THROW(read(bytes.substr(0, size)), Error) << size;
  }
  bytes[0] ^= 1;
  EXPECT_THROW(read(bytes), Error);
}

}  // namespace
}  // namespace lares::prolog::testing
