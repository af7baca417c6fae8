// OctoMap files (.bt, .ot), read node by node without building the tree.
//
// Format: the reading code of OctoMap 1.9 (Hornung et al., Autonomous Robots 2013, section 3.5).
// After a text header come the nodes in depth-first order. .bt: two bytes for each inner node, two
// bits for each child (00 unknown, 01 free, 10 occupied, 11 inner). .ot: for each node its log-odds
// (float32, little endian), the colour where the tree has one, and a byte with a bit for each
// child.
#pragma once

#include "mapping/environment/byte_reader.h"
#include "mapping/environment/layer_format.h"

namespace lares::environment {

// Throws kInvalid naming the byte when the header is not OctoMap's, the nodes end early, go deeper
// than 16 levels, are not as many as the header says, or bytes follow them. Bounds are those of the
// occupied voxels. Memory is constant, time linear in the bytes.
LayerFacts CheckOctomap(ByteReader& reader);

}  // namespace lares::environment
