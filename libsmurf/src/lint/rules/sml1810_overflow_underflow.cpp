// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1810_overflow_underflow_file {
namespace {

constexpr std::string_view kAsserts = "reads 0, and ends the process with an assertion";

constexpr std::string_view kCannotRead = "cannot read the number, and refuses the file";
constexpr std::string_view kComputes = "reads the number, and computes with it";

constexpr std::string_view kComputesStill = "computes with it where nothing moves";

constexpr std::string_view kTooSmall = "refuses so small a moment";

constexpr Fact kFacts[] = {
    {&readers::dart, Effect::crashes, kAsserts, kRun,
     at("box/@size").when(cases::kUnderflow).before({6, 20})},
    {&readers::dart, Effect::crashes, kAsserts, kRun,
     at("sphere/@radius").when(cases::kUnderflow).before({6, 20})},
    {&readers::dart, Effect::crashes, kAsserts, kRun,
     at("cylinder/@").when(cases::kUnderflow).before({6, 20})},
    {&readers::dart, Effect::crashes, kAsserts, kRun,
     at("mesh/@scale").when(cases::kUnderflow).before({6, 20})},
    {&readers::urdfdom, Effect::changes, "reads 0", kRun, when(cases::kUnderflow)},
    {&readers::gazebo, Effect::refuses,
     "computes with the number, and refuses the file if it cannot read the result", kRun,
     when(kUncertain)},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     at("inertial/origin/@xyz").when(cases::kTooLarge)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, at("limit/@").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun, at("inertia/@").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun,
     at("origin/@xyz").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun,
     at("sphere/@radius").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun,
     at("cylinder/@").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, kCannotRead, kRun,
     at("dynamics/@").when(cases::kSubnormal)},
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun,
     at("inertia/@").when(cases::kTooLarge)},
    {&readers::urdfdom, Effect::takes, "reads the number", kRun, when(cases::kSubnormal)},
    {&readers::urdfdom, Effect::changes, kComputes, kRun, when(cases::kTooLarge)},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the size", "4.0.0, run",
     at("mesh/@scale").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the size", "4.0.0, run",
     at("box/@size").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the size", "4.0.0, run",
     at("sphere/@radius").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the size", "4.0.0, run",
     at("cylinder/@").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the inertia", "4.0.0, run",
     at("inertia/@ixx").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the inertia", "4.0.0, run",
     at("inertia/@iyy").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses the inertia", "4.0.0, run",
     at("inertia/@izz").when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "reads 0, and refuses a moving body without mass",
     "4.0.0, run", at("mass/@value").when(cases::kUnderflow, kAlone).since({4, 0})},
    {&readers::mujoco, Effect::changes, "reads 0", "4.0.0, run",
     when(cases::kUnderflow).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kTooSmall, "4.0.0, run",
     at("inertia/@ixx").when(cases::kSubnormal).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kTooSmall, "4.0.0, run",
     at("inertia/@iyy").when(cases::kSubnormal).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kTooSmall, "4.0.0, run",
     at("inertia/@izz").when(cases::kSubnormal).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "refuses a product without moments", "4.0.0, run",
     at("inertia/@").when(cases::kSubnormal, kWithoutMoments).since({4, 0})},
    {&readers::mujoco, Effect::refuses, "refuses a moving body of so small a mass", "4.0.0, run",
     at("mass/@value").when(cases::kSubnormal, kAlone).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kCannotRead, "4.0.0, run",
     at("mesh/@scale").when(cases::kSubnormal).since({4, 0})},
    {&readers::mujoco, Effect::takes, "reads the number", "4.0.0, run",
     when(cases::kSubnormal).since({4, 0})},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     at("inertial/origin/@xyz").when(cases::kTooLarge, kCarried, kStill)},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     at("inertial/origin/@rpy").when(cases::kTooLarge, kCarried, kStill)},
    {&readers::mujoco, Effect::changes, kComputesStill, kRun,
     at("mass/@value").when(cases::kTooLarge, kCarried, kStill)},
    {&readers::mujoco, Effect::changes, kComputes, kRun,
     at("inertial/origin/@xyz").when(cases::kTooLarge, kAlone)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia that fixed links have together", kRun,
     at("inertial/origin/@xyz").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("origin/@xyz").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("origin/@rpy").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("axis/@xyz").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("mass/@value").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("box/@size").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("cylinder/@").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun,
     at("sphere/@radius").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("mesh/@scale").when(cases::kTooLarge)},
    {&readers::mujoco, Effect::changes, kComputes, kRun, at("mimic/@").when(cases::kTooLarge)},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp (atof), run",
     when(cases::kUnderflow)},
    {&readers::pybullet, Effect::changes, "reads infinity", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::drake, Effect::crashes, "reads 0, and ends the process at a box of that size", kRun,
     at("box").when(cases::kUnderflow)},
    {&readers::drake, Effect::crashes, "reads 0, and ends the process at a cylinder of that size",
     kRun, at("cylinder").when(cases::kUnderflow)},
    {&readers::drake, Effect::refuses, "refuses a scale below 1e-8", kRun,
     at("@scale").when(cases::kUnderflow)},
    {&readers::drake, Effect::refuses, "refuses a body of so small a mass", kRun,
     at("mass/@value").when(cases::kSubnormal)},
    {&readers::drake, Effect::changes, "reads 0", kRun, when(cases::kUnderflow)},
    {&readers::phobos, Effect::changes, "reads 0", kRun, when(cases::kUnderflow)},
    {&readers::phobos, Effect::takes, "reads the number", kRun, when(cases::kSubnormal)},
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
