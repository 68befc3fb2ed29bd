// SPDX-License-Identifier: BSD-3-Clause
// MARS 2 (mars-robot-simulation) with its envire model loader and its scene loader.
#include "base/findings/readers.hpp"

namespace smurf::readers::mars2_file {

extern constinit const Reader mars2{
    .name = "mars2",
    .title = "MARS 2",
    .basis = "envire_smurf_loader dbfa612, mars_scene_loader 685f76d, read; configmaps, executed",
    .like = &urdfdom,
    .reads_annotations = true};

}  // namespace smurf::readers::mars2_file
