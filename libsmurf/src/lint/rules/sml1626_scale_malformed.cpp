// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {

namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::breaks,
     "reports an error and drops the visuals and collisions of the link that follow",
     "urdfdom link.cpp:415-486, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::pybullet, Effect::changes, "uses one number for all axes", "Bullet, read"},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::drake, Effect::changes, "uses one number for all axes", "Drake, read"},
};

}  // namespace

extern constinit const Rule sml1626_scale_malformed{
    .id = "SML1626",
    .name = "scale-malformed",
    .severity = Severity::error,
    .summary = "The scale of a mesh does not have three numbers.",
    .why = "urdf-loader does not scale; yourdfpy uses one number for all axes.",
    .remedy = "Write one factor for each axis.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules
