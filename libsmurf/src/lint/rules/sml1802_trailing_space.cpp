// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "skips white space", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::takes, "skips white space", kRun},
    {&readers::drake, Effect::takes, "skips white space", "Drake detail_tinyxml.h:60-73"},
};

}  // namespace

extern constinit const Rule sml1802_trailing_space{
    .id = "SML1802",
    .name = "trailing-space",
    .severity = Severity::error,
    .summary = "White space follows a single number.",
    .why = "A mass written like this can cost all visuals and collisions of its link without a "
           "message.",
    .remedy = "Delete the white space.",
    .facts = kFacts};

}  // namespace smurf::rules
