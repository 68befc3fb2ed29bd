// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1113_required_attribute_missing_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, at("mesh")},
    {&readers::phobos, Effect::changes, "keeps it without a value", kRun, at("geometry")},
    {&readers::phobos, Effect::changes, "keeps it without a value", kRun, at("inertial")},
    {&readers::phobos, Effect::changes, "keeps it without a value", kRun, at("axis")},
    {&readers::phobos, Effect::changes, "keeps it without a value", kRun, at("safety_controller")},
    {&readers::phobos, Effect::changes, "keeps it without a value", kRun, at("robot/material")},
    {&readers::urdfdom, Effect::refuses, "refuses a link without a name", kRun,
     when(cases::kLinkTag)},
    {&readers::urdfdom, Effect::changes, "reads the axis 0 0 0", "urdfdom joint.cpp, run",
     at("axis")},
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun, at("joint")},
    urdfdom_drops_shapes(at("link")),
    {&readers::urdfdom, Effect::loses, "drops the material", "urdfdom model.cpp:146, run",
     at("material")},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::pybullet, Effect::ignores, "ignores mimic", kRun, at("mimic")},
    {&readers::pybullet, Effect::ignores, "ignores safety controllers", kRun,
     at("safety_controller")},
    {&readers::pybullet, Effect::changes, "reads absent moments as 0",
     "Bullet UrdfParser.cpp:321-339, run", at("inertia")},
    {&readers::pybullet, Effect::changes, "leaves the colour at its default",
     "Bullet UrdfParser.cpp, run", at("color")},
    {&readers::pybullet, Effect::changes, "reads the axis 0 0 0", "Bullet UrdfParser.cpp, run",
     at("axis")},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp:1452, run",
     at("limit")},
    {&readers::pybullet, Effect::changes, "reads no such material", kRun, at("robot/material")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::refuses, "reports error E9, an axis of length 0", kRun, at("axis")},
    {&readers::mujoco, Effect::refuses, "needs the name of a material without a colour", kRun,
     when(cases::kColourless)},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun, at("color")},
    {&readers::mujoco, Effect::takes, "does not need the name of a material", kRun, at("material")},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", kRun, at("color")},
    {&readers::drake, Effect::takes, "does not need the name of a material in a visual", kRun,
     at("visual/material")},
    {&readers::drake, Effect::changes, "reads 0, which makes most inertias impossible", kRun,
     at("inertial")},
    {&readers::drake, Effect::ignores, "ignores safety controllers", kRun, at("safety_controller")},
    {&readers::drake, Effect::changes, "uses the axis 1 0 0", kRun, at("axis")},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1113_required_attribute_missing{
    .id = "SML1113",
    .name = "required-attribute-missing",
    .severity = Severity::error,
    .summary = "An element lacks an attribute that readers need.",
    .remedy = "Add the attribute.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1113_required_attribute_missing_file
