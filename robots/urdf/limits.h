// How much of a URDF is read.
#pragma once

#include <cstddef>

namespace lares::urdf {

// What is beyond a limit is refused with the limit's name in the message.
struct Limits {
  std::size_t max_bytes = 64u << 20;        // of the document
  int max_depth = 64;                       // of nested elements
  std::size_t max_elements = 500'000;       // of all kinds
  std::size_t max_links = 2'000;            // children of <robot>
  std::size_t max_joints = 2'000;           // children of <robot>
  std::size_t max_sensors = 500;            // of all forms
  std::size_t max_chain = 200;              // joints from the root to a link
  std::size_t max_value_bytes = 64u << 10;  // of an attribute or an element's text
};

}  // namespace lares::urdf
