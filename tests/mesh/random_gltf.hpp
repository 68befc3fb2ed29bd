// SPDX-License-Identifier: BSD-3-Clause
// glTF files that express the same things in many ways.
#pragma once

#include <map>
#include <string>

#include "unit/random.hpp"

namespace smurf::test {

struct GltfFile {
  std::string name, bytes;
  std::map<std::string, std::string> beside;  ///< buffers, by their names
};
/// Text or binary, with nodes, strides, all types of indices and all primitives with triangles.
GltfFile random_gltf(Random& random);

/// A binary file with these chunks.
std::string gltf_binary(const std::string& json, const std::string& buffer);

}  // namespace smurf::test
