#include "reasoner/prolog_worker/snapshot_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace lares::prolog {
namespace {

constexpr std::uint64_t kMagic = 0x31304e534552414cull;  // "LARESN01"

// ---- Writing -----------------------------------------------------------------------------------

// Numbers in the machine's own order: the reader is the same program on the same machine.
class Writer {
 public:
  explicit Writer(int fd) : fd_(fd) { buffer_.reserve(kBuffer + 64); }

  template <typename Number>
  void Put(Number number) {
    Append(&number, sizeof number);
  }
  void PutText(std::string_view text) {
    Put(static_cast<std::uint32_t>(text.size()));
    Append(text.data(), text.size());
  }
  // The number of bytes in all.
  std::size_t Finish() {
    Flush();
    return size_;
  }

 private:
  static constexpr std::size_t kBuffer = 1u << 18;

  void Append(const void* bytes, std::size_t size) {
    buffer_.append(static_cast<const char*>(bytes), size);
    if (buffer_.size() >= kBuffer) Flush();
  }

  void Flush() {
    for (std::string_view rest = buffer_; !rest.empty();) {
      const ssize_t written = ::write(fd_, rest.data(), rest.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        throw Error(Code::kUnavailable, "there is no memory for another copy of the knowledge");
      }
      rest.remove_prefix(static_cast<std::size_t>(written));
    }
    size_ += buffer_.size();
    buffer_.clear();
  }

  int fd_;
  std::string buffer_;
  std::size_t size_ = 0;
};

// New numbers for the terms in use, in the order of the old ones: what was sorted stays so.
class Numbering {
 public:
  explicit Numbering(std::size_t terms) : numbers_(terms + 1) {}

  void Use(rdf::TermId id) { numbers_[static_cast<std::uint32_t>(id)] = 1; }
  void Use(const rdf::Triple& triple) {
    for (const rdf::TermId id : {triple.subject, triple.predicate, triple.object}) Use(id);
  }
  // The terms in use; from here on Get() holds.
  std::vector<rdf::TermId> Number() {
    std::vector<rdf::TermId> used;
    for (std::uint32_t id = 1; id < numbers_.size(); ++id) {
      if (numbers_[id] == 0) continue;
      used.push_back(rdf::TermId{id});
      numbers_[id] = static_cast<std::uint32_t>(used.size());
    }
    return used;
  }
  std::uint32_t Get(rdf::TermId id) const { return numbers_[static_cast<std::uint32_t>(id)]; }

 private:
  std::vector<std::uint32_t> numbers_;
};

struct Content {
  std::vector<const rdf::Graph*> graphs;
  std::vector<rdf::Triple> inferred;
};

Content ContentOf(const rdf::View& view) {
  Content content;
  for (const auto& layer : view.layers()) {
    for (const rdf::Graph& graph : layer->graphs()) content.graphs.push_back(&graph);
  }
  const bool whole = view.ForEach({}, [&](const rdf::Triple& triple) {
    if (!view.IsAsserted(triple)) content.inferred.push_back(triple);
    return content.inferred.size() <= SnapshotFile::kMaxTriples;
  });
  if (!whole) {
    throw Error(Code::kTooLarge, "the knowledge has too many statements for a goal of its own");
  }
  return content;
}

Numbering NumberTerms(const rdf::View& view, const Content& content) {
  Numbering numbering(view.dictionary().size());
  for (const rdf::Triple& triple : content.inferred) numbering.Use(triple);
  for (const rdf::Graph* graph : content.graphs) {
    for (const rdf::Triple& triple : graph->triples) numbering.Use(triple);
    for (const auto& [canonical, written] : graph->as_written) {
      numbering.Use(canonical);
      numbering.Use(written);
    }
  }
  return numbering;
}

void PutTriples(Writer& writer, const Numbering& numbering,
                const std::vector<rdf::Triple>& triples) {
  writer.Put(static_cast<std::uint64_t>(triples.size()));
  for (const rdf::Triple& triple : triples) {
    for (const rdf::TermId id : {triple.subject, triple.predicate, triple.object}) {
      writer.Put(numbering.Get(id));
    }
  }
}

std::size_t WriteContent(int fd, const rdf::View& view) {
  const Content content = ContentOf(view);
  Numbering numbering = NumberTerms(view, content);
  const std::vector<rdf::TermId> terms = numbering.Number();
  Writer writer(fd);
  writer.Put(kMagic);
  writer.Put(static_cast<std::uint64_t>(terms.size()));
  for (const rdf::TermId id : terms) {
    const rdf::TermView term = view.dictionary().Get(id);
    writer.Put(static_cast<std::uint8_t>(term.kind));
    writer.PutText(term.value);
    if (term.kind != rdf::TermKind::kLiteral) continue;
    writer.PutText(term.datatype);
    writer.PutText(term.language);
  }
  writer.Put(static_cast<std::uint64_t>(content.graphs.size()));
  for (const rdf::Graph* graph : content.graphs) {
    writer.PutText(graph->name);
    PutTriples(writer, numbering, graph->triples);
    writer.Put(static_cast<std::uint64_t>(graph->as_written.size()));
    for (const auto& [canonical, written] : graph->as_written) {
      writer.Put(numbering.Get(canonical));
      writer.Put(numbering.Get(written));
    }
  }
  PutTriples(writer, numbering, content.inferred);
  return writer.Finish();
}

// ---- Reading -----------------------------------------------------------------------------------

class Mapping {
 public:
  explicit Mapping(int fd) {
    struct stat status {};
    if (::fstat(fd, &status) != 0) throw Error(Code::kIo, "the snapshot cannot be read");
    size_ = static_cast<std::size_t>(status.st_size);
    address_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd, 0);
    if (address_ == MAP_FAILED) throw Error(Code::kIo, "the snapshot cannot be read");
  }
  ~Mapping() { ::munmap(address_, size_); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(address_), size_}; }

 private:
  void* address_ = nullptr;
  std::size_t size_ = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <typename Number>
  Number Get() {
    Number number{};
    std::memcpy(&number, Take(sizeof number).data(), sizeof number);
    return number;
  }
  // A count of things that take at least `size` bytes each.
  std::size_t Count(std::size_t size) {
    const auto count = Get<std::uint64_t>();
    if (count > rest_.size() / size) Fail();
    return static_cast<std::size_t>(count);
  }
  std::string_view Text() { return Take(Get<std::uint32_t>()); }

  std::vector<rdf::Triple> Triples(const std::vector<rdf::TermId>& terms) {
    std::vector<rdf::Triple> triples(Count(3 * sizeof(std::uint32_t)));
    for (rdf::Triple& triple : triples) {
      triple.subject = Term(terms);
      triple.predicate = Term(terms);
      triple.object = Term(terms);
    }
    return triples;
  }
  rdf::TermId Term(const std::vector<rdf::TermId>& terms) {
    const auto number = Get<std::uint32_t>();
    if (number == 0 || number >= terms.size()) Fail();
    return terms[number];
  }
  [[noreturn]] static void Fail() { throw Error(Code::kInvalid, "the snapshot is damaged"); }

 private:
  std::string_view Take(std::size_t size) {
    if (size > rest_.size()) Fail();
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  std::string_view rest_;
};

std::vector<rdf::TermId> ReadTerms(Reader& reader, rdf::Dictionary& dictionary) {
  const std::size_t count = reader.Count(5);
  std::vector<rdf::TermId> terms{rdf::kAnyTerm};
  terms.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto kind = reader.Get<std::uint8_t>();
    if (kind > static_cast<std::uint8_t>(rdf::TermKind::kLiteral)) Reader::Fail();
    rdf::TermView term{static_cast<rdf::TermKind>(kind), reader.Text(), {}, {}};
    if (term.kind == rdf::TermKind::kLiteral) {
      term.datatype = reader.Text();
      term.language = reader.Text();
    }
    terms.push_back(dictionary.Intern(term));
  }
  return terms;
}

rdf::Graph ReadGraph(Reader& reader, const std::vector<rdf::TermId>& terms) {
  rdf::Graph graph;
  graph.name = reader.Text();
  graph.triples = reader.Triples(terms);
  if (!std::is_sorted(graph.triples.begin(), graph.triples.end())) {
    std::sort(graph.triples.begin(), graph.triples.end());
  }
  const std::size_t renamed = reader.Count(2 * sizeof(std::uint32_t));
  for (std::size_t i = 0; i < renamed; ++i) {
    const rdf::TermId canonical = reader.Term(terms);
    graph.as_written.emplace(canonical, reader.Term(terms));
  }
  return graph;
}

}  // namespace

SnapshotFile::SnapshotFile(const rdf::View& view)
    : fd_(::memfd_create("lares-snapshot", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (fd_ < 0) throw Error(Code::kUnavailable, "there is no file for a copy of the knowledge");
  try {
    size_ = WriteContent(fd_, view);
    constexpr int kSeals = F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;
    if (::fcntl(fd_, F_ADD_SEALS, kSeals) != 0) {
      throw Error(Code::kInternal, "the copy of the knowledge cannot be sealed");
    }
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

SnapshotFile::~SnapshotFile() { ::close(fd_); }

rdf::View ReadSnapshot(int fd) {
  const Mapping mapping(fd);
  Reader reader(mapping.bytes());
  if (reader.Get<std::uint64_t>() != kMagic) Reader::Fail();
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const std::vector<rdf::TermId> terms = ReadTerms(reader, *dictionary);
  std::vector<rdf::Graph> graphs(reader.Count(1));
  for (rdf::Graph& graph : graphs) graph = ReadGraph(reader, terms);
  rdf::Inference inference;
  inference.inferred = reader.Triples(terms);
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(std::move(graphs), std::move(inference)));
}

}  // namespace lares::prolog
