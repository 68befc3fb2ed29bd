// SPDX-License-Identifier: BSD-3-Clause
// Where meshes and images are read from: what a model may name, not all of the disk.
#pragma once

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf::load_check {

/// Must not outlive the reader.
struct ShapeFiles {
  const FileReader& files;
  Limits limits{};
};

}  // namespace smurf::load_check
