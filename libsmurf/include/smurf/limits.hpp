// SPDX-License-Identifier: BSD-3-Clause
// Bounds on what a file may demand. Reaching one is a diagnostic, never a crash or a hang.
#pragma once

#include <cstdint>

namespace smurf {

struct Limits {
  std::uint64_t file_bytes = 256ULL << 20U;      ///< a text file that is read whole
  std::uint64_t mesh_bytes = 128ULL << 20U;      ///< a mesh file; 2.7 million triangles of STL
  std::uint32_t yaml_depth = 100;                ///< nested lists and mappings
  std::uint64_t yaml_expanded_nodes = 20000000;  ///< nodes after aliases are followed
  std::uint32_t xml_depth = 90;                  ///< nested elements; tinyxml2 stops at 99
  std::uint32_t xml_attributes = 1000;           ///< attributes of one element
  std::uint32_t include_depth = 64;              ///< scenes inside scenes
  std::uint64_t instances = 1000000;             ///< entities after nested scenes are expanded
};

}  // namespace smurf
