// SPDX-License-Identifier: BSD-3-Clause
// Bullet's URDF reader, which PyBullet uses.
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"

namespace smurf::readers::pybullet_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18",
     {&pybullet, refuses, "refuses an axis that is not a vector", kRun,
      at("axis").unless(cases::kEnoughWords)}},
    {"SML18",
     {&pybullet, changes, "reads the leading digits, or 0", "Bullet UrdfParser.cpp (atof), run"}},
};

}  // namespace

extern constinit const Reader pybullet{.name = "pybullet",
                                       .title = "PyBullet",
                                       .basis = "PyBullet 3.2.7 executed (Bullet 6c888f4, 2025-01)",
                                       .like = &urdf,
                                       .version = "Bullet 2025-01",
                                       .families = kFamilies};

}  // namespace smurf::readers::pybullet_file
