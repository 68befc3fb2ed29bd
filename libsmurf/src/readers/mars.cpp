// SPDX-License-Identifier: BSD-3-Clause
// MARS 1 (rock-simulation/mars) with its SMURF and scene loaders.
#include "base/findings/readers.hpp"

namespace smurf::readers::mars_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML31",
     {&mars, loses, "finds nothing of that name, and prints no message",
      "MARS smurf.cpp:155-181, 333-449"}},
};

}  // namespace

extern constinit const Reader mars{
    .name = "mars",
    .title = "MARS 1",
    .basis = "71a5c45: its loaders, configmaps, smurf_parser and ODE 0.16.2 run, the rest read",
    .like = &urdfdom,
    .version = "MARS 71a5c45",
    .families = kFamilies,
    .reads_annotations = true};

}  // namespace smurf::readers::mars_file
