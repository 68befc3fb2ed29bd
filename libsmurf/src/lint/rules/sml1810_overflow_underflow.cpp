// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"
#include "base/uncertain.hpp"

namespace smurf::rules::sml1810_overflow_underflow_file {
namespace {

constexpr std::string_view kAsserts = "reads 0, and ends the process with an assertion";

constexpr std::string_view kCannotRead = "cannot read the number, and refuses the file";
constexpr std::string_view kComputes = "reads the number, and computes with it";

constexpr std::string_view kComputesStill = "computes with it where nothing moves";

constexpr Fact kFacts[] = {
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/box/@size/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/sphere/@radius/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/cylinder/@radius/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/cylinder/@length/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/mesh/@scale/#underflow"},
    {&readers::urdfdom, Effect::changes, "reads 0", kRun, "#underflow"},
    {&readers::gazebo, Effect::refuses,
     "computes with the number, and refuses the file if it cannot read the result", kRun,
     kUncertain},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertial/origin/@xyz/#too-large"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/limit/@lower/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/limit/@upper/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/limit/@effort/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/limit/@velocity/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@ixx/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@ixy/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@ixz/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@iyy/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@iyz/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/inertia/@izz/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/origin/@xyz/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/sphere/@radius/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/cylinder/@radius/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/cylinder/@length/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/dynamics/@damping/#subnormal"},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, "/dynamics/@friction/#subnormal"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@ixx/#too-large"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@ixy/#too-large"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@ixz/#too-large"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@iyy/#too-large"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@iyz/#too-large"},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     "/inertia/@izz/#too-large"},
    {&readers::urdfdom, Effect::takes, "reads the number", kRun, "#subnormal"},
    {&readers::urdfdom, Effect::changes, kComputes, kRun, "#too-large"},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     "/inertial/origin/@xyz/#too-large#carried#still"},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     "/inertial/origin/@rpy/#too-large#carried#still"},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     "/mass/@value/#too-large#uncertain#carried#still"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/inertial/origin/@xyz/#too-large#alone"},
    {&readers::mujoco, Effect::refuses, "refuses the inertia that fixed links have together", kRun,
     "/inertial/origin/@xyz/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/origin/@xyz/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/origin/@rpy/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/axis/@xyz/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/mass/@value/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/box/@size/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/cylinder/@radius/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/cylinder/@length/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/sphere/@radius/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/mesh/@scale/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/mimic/@multiplier/#too-large"},
    {&readers::mujoco, Effect::changes, kComputes, kRun, "/mimic/@offset/#too-large"},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp (atof), run",
     "#underflow"},
    {&readers::pybullet, Effect::changes, "reads infinity", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::drake, Effect::changes, "reads 0", "Drake detail_tinyxml.h:60-73", "#underflow"},
    {&readers::phobos, Effect::changes, "reads 0", kRun, "#underflow"},
    {&readers::phobos, Effect::takes, "reads the number", kRun, "#subnormal"},
    {&readers::phobos, Effect::changes, "reads infinity", kRun},
};

}  // namespace

extern constinit const Rule sml1810_overflow_underflow{
    .id = "SML1810",
    .name = "overflow-underflow",
    .severity = Severity::error,
    .summary = "A number is too large or too small for a double.",
    .remedy = "Write a number between 2.2e-308 and 1.8e308, or 0.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1810_overflow_underflow_file
