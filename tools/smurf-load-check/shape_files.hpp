// SPDX-License-Identifier: BSD-3-Clause
// The meshes and images that a model may name; other files of the disk are not read.
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
