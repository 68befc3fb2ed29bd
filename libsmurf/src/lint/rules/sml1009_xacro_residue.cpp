// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1009_xacro_residue_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, at("origin/@")},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, at("axis/@")},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, at("child/@")},
    {&readers::phobos, Effect::changes, "treats it as a part of the robot", kRun},
    {&readers::urdf, Effect::loses,
     "ignores the element, so everything it would expand to is missing",
     "urdfdom, sdformat, MuJoCo, Bullet, run", at("xacro:")},
    {&readers::urdf, Effect::changes, "uses the text literally", "no URDF reader expands xacro",
     at("@filename")},
    {&readers::urdf, Effect::changes, "uses the text literally", "no URDF reader expands xacro",
     at("@name")},
    {&readers::urdfdom, Effect::changes,
     "does not look for the leading joint, so the joint moves freely", kRun, at("mimic/@joint")},
    {&readers::urdfdom, Effect::ignores, "does not look at it", kRun, at("gazebo")},
    {&readers::urdfdom, Effect::loses, "drops the material with a message", kRun, at("material")},
    {&readers::urdfdom, Effect::loses,
     "ignores the element, so everything it would expand to is missing", kRun, at("xacro:")},
    {&readers::pinocchio, Effect::refuses,
     "uses the text literally, finds no file, and refuses the shapes", kRun, at("mesh/@filename")},
    {&readers::urdfdom, Effect::changes, "uses the text literally", kRun, at("@filename")},
    {&readers::urdfdom, Effect::changes, "uses the text literally", kRun, at("@name")},
    {&readers::urdfdom, Effect::refuses, "refuses the number, and with it the file", kRun,
     at("joint")},
    urdfdom_drops_shapes(at("link")),
    {&readers::pybullet, Effect::loses,
     "ignores the element, so everything it would expand to is missing", kRun, at("xacro:")},
    {&readers::pybullet, Effect::loses, "does without a texture", kRun, at("texture/@filename")},
    {&readers::pybullet, Effect::refuses, "finds no file of that name, and refuses the robot", kRun,
     at("@filename")},
    {&readers::pybullet, Effect::refuses, "finds no link of that name", kRun, at("@link")},
    {&readers::pybullet, Effect::refuses, "refuses an axis that is not a vector", kRun,
     at("axis/@xyz")},
    {&readers::drake, Effect::refuses, "finds no file of that name, and refuses the robot", kRun,
     at("@filename")},
    {&readers::pybullet, Effect::changes, "uses the text literally", kRun, at("@name")},
    {&readers::pybullet, Effect::changes, "reads the leading digits, or 0",
     "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::loses,
     "ignores the element, so everything it would expand to is missing", kRun, at("xacro:")},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::refuses, "uses the text literally, and finds no file", kRun,
     at("@filename")},
    {&readers::mujoco, Effect::changes, "finds no joint of that name, so the joint moves freely",
     kRun, at("mimic/@joint")},
    {&readers::mujoco, Effect::changes, "uses the text literally", kRun, at("@name")},
    {&readers::mujoco, Effect::refuses, "refuses a number or name with an expression in it", kRun},
    {&readers::drake, Effect::loses,
     "ignores the element, so everything it would expand to is missing", kRun, at("xacro:")},
    {&readers::drake, Effect::refuses, "finds no joint of that name", kRun,
     at("transmission/joint/@name")},
    {&readers::drake, Effect::changes, "uses the text literally", kRun, at("@name")},
    {&readers::drake, Effect::refuses, "refuses the number", kRun},
    {&readers::gazebo, Effect::changes, "uses the text literally, and finds nothing of that name",
     kRun, at("gazebo")},
    {&readers::dart, Effect::refuses,
     "uses the text literally, finds no file, and refuses the model", kRun, at("@filename")},
};

}  // namespace

extern constinit const Rule sml1009_xacro_residue{
    .id = "SML1009",
    .name = "xacro-residue",
    .severity = Severity::error,
    .summary = "A file still contains xacro elements or expressions.",
    .why = "No URDF reader expands xacro.",
    .remedy = "Name the file .urdf.xacro, and make the URDF with smurf2urdf.",
    .sources = "25 of 322 files of the Tola/Corke dataset.",
    .facts = kFacts,
    .blocks_building = true,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1009_xacro_residue_file
