// SPDX-License-Identifier: BSD-3-Clause
// The files that a glTF 2.0 file names, with the places of the names.
#pragma once

#include <vector>

#include "mesh/gltf_data.hpp"
#include "smurf/mesh.hpp"

namespace smurf::gltf {

/// The buffers and images that are other files, in the order of the file.
std::vector<MeshDependency> names_in(const Data& data);

}  // namespace smurf::gltf
