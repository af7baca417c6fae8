#include "mapping/environment/octomap_format.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/text.h"
#include "mapping/environment/facts.h"
#include "mapping/environment/magic.h"

namespace lares::environment {
namespace {

constexpr int kMaxDepth = 16;
static_assert(kOctomapSide == 1U << kMaxDepth);
constexpr std::size_t kMaxHeaderLine = 1024;
constexpr int kMaxHeaderLines = 256;
constexpr char kBinaryStart[] = "# Octomap OcTree binary file";
constexpr char kFullStart[] = "# Octomap OcTree file";
static_assert(std::endian::native == std::endian::little, "log-odds are read as they stand");

using Header = OctomapHeader;
using LeafVisitor = std::function<void(const OctomapHeader&, const OctomapLeaf&)>;

// A cube of voxels: its lowest corner as voxel indices from the tree's lowest corner.
struct Cube {
  std::uint32_t x = 0, y = 0, z = 0;
  int depth = 0;

  std::uint32_t edge() const { return 1U << (kMaxDepth - depth); }
  // Bit 0 of `index` is the upper half in x, bit 1 in y, bit 2 in z.
  Cube Child(int index) const {
    const std::uint32_t half = edge() / 2;
    return {x + (index & 1 ? half : 0), y + (index & 2 ? half : 0), z + (index & 4 ? half : 0),
            depth + 1};
  }
};

template <typename Number>
Number ParseNumber(ByteReader& reader, const std::string& keyword, std::string_view text) {
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) {
    reader.Fail("the header's '" + keyword + "' is not a number: '" + Excerpt(text) + "'");
  }
  return number;
}

void ReadHeaderLine(ByteReader& reader, std::string_view line, Header& header) {
  const std::size_t gap = line.find_first_of(" \t");
  const std::string keyword(line.substr(0, gap));
  const std::string_view value =
      gap == std::string_view::npos ? std::string_view() : Trim(line.substr(gap));
  if (keyword == "id") header.id = value;
  if (keyword == "size") header.size = ParseNumber<std::uint64_t>(reader, keyword, value);
  if (keyword == "res") header.resolution_m = ParseNumber<double>(reader, keyword, value);
}

Header ReadHeader(ByteReader& reader) {
  const std::string_view front = reader.PeekFront(512);
  Header header;
  header.is_binary = front.starts_with(kBinaryStart);
  if (!header.is_binary && !front.starts_with(kFullStart)) {
    reader.Fail(NotA("an OctoMap file", front));
  }
  bool has_data = false;
  for (int i = 0; i < kMaxHeaderLines && !has_data; ++i) {
    const std::optional<std::string> line = reader.ReadLine(kMaxHeaderLine);
    if (!line) reader.Fail("the header has no 'data' line");
    const std::string_view text = Trim(*line);
    has_data = text == "data";
    if (!has_data && !text.empty() && text[0] != '#') ReadHeaderLine(reader, text, header);
  }
  if (!has_data) reader.Fail("the header has no 'data' line");
  if (header.id == "1") header.id = "OcTree";  // as files before OctoMap 1.4 say
  if (!(header.resolution_m >= 1e-6 && header.resolution_m <= 1000)) {
    reader.Fail("the header's resolution must be between 0.000001 and 1000 m, not " +
                ToText(header.resolution_m));
  }
  return header;
}

// Bytes that a node of the tree class holds beside its log-odds.
std::size_t PayloadBytes(const ByteReader& reader, const Header& header) {
  if (header.id == "OcTree" || (header.id == "OcTreeStamped")) return 0;
  if (header.id == "ColorOcTree") return 3;
  reader.Fail("the tree class '" + Excerpt(header.id) +
              "' is not known here (OcTree, OcTreeStamped, ColorOcTree)");
}

class Traversal {
 public:
  Traversal(ByteReader& reader, const Header& header, const LeafVisitor& visit)
      : reader_(reader), header_(header), visit_(visit) {
    payload_ = PayloadBytes(reader, header);
  }

  // The number of nodes.
  std::uint64_t Run() {
    if (header_.size == 0) return 0;
    Visit(Cube{});
    while (depth_ >= 0) {
      Inner& inner = stack_[depth_];
      if (inner.next_child == 8) {
        --depth_;
        continue;
      }
      const int child = inner.next_child++;
      const Cube cube = inner.cube.Child(child);
      if (header_.is_binary) {
        VisitBinaryChild((inner.bits >> (2 * child)) & 3, cube);
      } else if ((inner.bits >> child & 1) != 0) {
        Visit(cube);
      }
    }
    return nodes_;
  }

 private:
  struct Inner {
    Cube cube;
    unsigned bits = 0;
    int next_child = 0;
  };

  // A child of an inner node of .bt: its state is in the parent.
  void VisitBinaryChild(unsigned state, const Cube& cube) {
    if (state == 0) return;
    if (state == 3) return Visit(cube);
    CountNode();
    VisitLeaf(cube, state == 2);
  }

  // A node that has bytes of its own: every node of .ot, the inner ones of .bt.
  void Visit(const Cube& cube) {
    CountNode();
    return header_.is_binary ? VisitBinary(cube) : VisitFull(cube);
  }

  void VisitBinary(const Cube& cube) {
    unsigned char bytes[2];
    ReadExactly(bytes, sizeof bytes);
    const unsigned bits = bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
    if (bits == 0 && cube.depth > 0) Fail("an inner node has no children");
    Push(cube, bits);
  }

  void VisitFull(const Cube& cube) {
    unsigned char bytes[8];
    ReadExactly(bytes, 5 + payload_);
    float log_odds = 0;
    std::memcpy(&log_odds, bytes, sizeof log_odds);
    if (!std::isfinite(log_odds)) Fail("the log-odds of a node are not a finite number");
    const unsigned bits = bytes[4 + payload_];
    if (bits != 0) return Push(cube, bits);
    VisitLeaf(cube, log_odds >= 0);
  }

  void VisitLeaf(const Cube& cube, bool is_occupied) const {
    visit_(header_, {cube.x, cube.y, cube.z, cube.edge(), is_occupied});
  }

  void Push(const Cube& cube, unsigned bits) {
    if (bits == 0) return;
    if (cube.depth == kMaxDepth) Fail("a node has children below the 16th level");
    stack_[++depth_] = {cube, bits, 0};
  }

  void CountNode() {
    if (++nodes_ > header_.size) {
      Fail("there are more nodes than the " + std::to_string(header_.size) +
           " that the header says");
    }
  }

  void ReadExactly(unsigned char* into, std::size_t count) {
    if (!reader_.Read(reinterpret_cast<char*>(into), count)) {
      Fail("the file ends in node " + std::to_string(nodes_) + " of " +
           std::to_string(header_.size));
    }
  }

  [[noreturn]] void Fail(const std::string& message) const { reader_.Fail(message); }

  ByteReader& reader_;
  const Header& header_;
  const LeafVisitor& visit_;
  std::size_t payload_ = 0;
  Inner stack_[kMaxDepth];
  int depth_ = -1;  // of the stack's top
  std::uint64_t nodes_ = 0;
};

// What a check adds up.
struct Tally {
  std::uint64_t occupied = 0, free = 0;
  std::uint32_t low[3] = {UINT32_MAX, UINT32_MAX, UINT32_MAX};
  std::uint32_t high[3] = {0, 0, 0};

  void Add(const OctomapLeaf& leaf) {
    if (!leaf.is_occupied) {
      ++free;
      return;
    }
    ++occupied;
    const std::uint32_t corner[3] = {leaf.x, leaf.y, leaf.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], corner[axis]);
      high[axis] = std::max(high[axis], corner[axis] + leaf.edge);
    }
  }
};

}  // namespace

OctomapHeader ReadOctomap(ByteReader& reader, const LeafVisitor& visit) {
  const Header header = ReadHeader(reader);
  const std::uint64_t nodes = Traversal(reader, header, visit).Run();
  if (nodes != header.size) {
    reader.Fail("the tree has " + std::to_string(nodes) + " nodes, the header says " +
                std::to_string(header.size));
  }
  if (reader.Peek() >= 0) reader.Fail("bytes follow the last node");
  return header;
}

LayerFacts CheckOctomap(ByteReader& reader) {
  Tally tally;
  const Header header =
      ReadOctomap(reader, [&](const Header&, const OctomapLeaf& leaf) { tally.Add(leaf); });
  LayerFacts facts;
  facts.media_type = "application/x-octomap";
  facts.facts = {{"format", header.is_binary ? "bt" : "ot"},
                 {"tree", header.id},
                 {"resolution_m", ToText(header.resolution_m)},
                 {"nodes", std::to_string(header.size)},
                 {"occupied_leaves", std::to_string(tally.occupied)},
                 {"free_leaves", std::to_string(tally.free)}};
  if (tally.occupied == 0) return facts;
  facts.bounds_m.emplace();
  constexpr double kOriginVoxel = kOctomapOrigin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (*facts.bounds_m)[axis] = (tally.low[axis] - kOriginVoxel) * header.resolution_m;
    (*facts.bounds_m)[axis + 3] = (tally.high[axis] - kOriginVoxel) * header.resolution_m;
  }
  return facts;
}

}  // namespace lares::environment
