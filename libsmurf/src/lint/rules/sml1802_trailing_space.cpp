// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "skips blanks", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::takes, "skips blanks", kRun},
    {&readers::drake, Effect::takes, "skips blanks", "Drake detail_tinyxml.h:60-73"},
};

}  // namespace

extern constinit const Rule sml1802_trailing_space{
    .id = "SML1802",
    .name = "trailing-space",
    .severity = Severity::error,
    .summary = "A blank follows a single number.",
    .why =
        "A mass written like this can cost all visuals and collisions of its link without a message.",
    .remedy = "Delete the blank.",
    .facts = kFacts};

}  // namespace smurf::rules
