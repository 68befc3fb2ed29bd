// SPDX-License-Identifier: BSD-3-Clause
// MARS with envire (envire4mars), the generation between MARS 1 and MARS 2.
#include "base/findings/readers.hpp"

namespace smurf::readers::envire_file {

extern constinit const Reader envire{
    .name = "envire",
    .title = "MARS with envire",
    .basis = "rock-cpp/smurf 3e3b886, envire_smurf_loader 91afc56, read; configmaps, executed",
    .like = &urdfdom,
    .reads_annotations = true};

}  // namespace smurf::readers::envire_file
