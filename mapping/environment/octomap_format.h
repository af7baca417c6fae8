// OctoMap files (.bt, .ot), read node by node without building the tree.
//
// Format: the reading code of OctoMap 1.9 (Hornung et al., Autonomous Robots 2013, section 3.5).
// After a text header come the nodes in depth-first order. .bt: two bytes for each inner node, two
// bits for each child (00 unknown, 01 free, 10 occupied, 11 inner). .ot: for each node its log-odds
// (float32, little endian), the colour where the tree has one, and a byte with a bit for each
// child.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mapping/environment/byte_reader.h"
#include "mapping/environment/layer_format.h"

namespace lares::environment {

struct OctomapHeader {
  bool is_binary = false;
  std::string id;  // class of the tree: "OcTree"
  std::uint64_t size = 0;
  double resolution_m = 0;  // side of a voxel
};

// A cube of voxels that are all alike; what lies in none of a tree's leaves is unknown.
struct OctomapLeaf {
  std::uint32_t x = 0, y = 0, z = 0;  // its lowest voxel; kOctomapOrigin is the one above 0 m
  std::uint32_t edge = 1;             // in voxels
  bool is_occupied = false;           // of .ot: log-odds of 0 or more
};
inline constexpr std::uint32_t kOctomapOrigin = 1U << 15;
inline constexpr std::uint32_t kOctomapSide = 1U << 16;  // voxels along each side of the whole tree

// Calls `visit` for each leaf as it comes by and gives back the header. Throws as CheckOctomap,
// which may be after leaves were visited.
OctomapHeader ReadOctomap(
    ByteReader& reader, const std::function<void(const OctomapHeader&, const OctomapLeaf&)>& visit);

// Throws kInvalid naming the byte when the header is not OctoMap's, the nodes end early, go deeper
// than 16 levels, are not as many as the header says, or bytes follow them. Bounds are those of the
// occupied voxels. Memory is constant, time linear in the bytes.
LayerFacts CheckOctomap(ByteReader& reader);

}  // namespace lares::environment
