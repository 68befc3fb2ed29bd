// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1804_number_infinite_file {
namespace {

constexpr std::string_view kNotPositive = "refuses a size that is not positive";

constexpr std::string_view kBody = "refuses a moving body of such an inertia";
constexpr std::string_view kRuns = "2.3.7, 3.3.7 and 4.0.0, run";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "reads infinity", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::refuses, "refuses the size", "3.2.0, run",
     at("mesh/@scale").before({3, 2, 3})},
    {&readers::mujoco, Effect::refuses, "refuses more numbers than it expects", kRun,
     when(cases::kTooMany)},
    {&readers::mujoco, Effect::refuses, "refuses fewer numbers than it expects", kRun,
     when(cases::kTooFew)},
    {&readers::mujoco, Effect::refuses, "cannot read such a word as a scale", kRun,
     when(cases::kLongWord)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "3.1.3, run",
     at("inertia/@ixx").before({3, 1, 5})},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "3.1.3, run",
     at("inertia/@izz").before({3, 1, 5})},
    {&readers::mujoco, Effect::refuses, kBody, kRuns, at("inertia").when(kCarried, kAlone)},
    {&readers::mujoco, Effect::refuses, kBody, kRuns, at("mass").when(kCarried, kAlone)},
    {&readers::mujoco, Effect::refuses, kBody, "4.0.0, run",
     at("inertial/origin/@rpy").when(kCarried, kAlone).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kBody, "2.3.7, run",
     at("inertial/origin/@rpy").when(kCarried, kAlone).before({3, 0})},
    {&readers::mujoco, Effect::refuses, kBody, kRuns,
     at("inertial/origin/@xyz").when(kCarried, kAlone)},
    {&readers::mujoco, Effect::changes, "computes with it where the body does not move by itself",
     kRun, when(kCarried)},
    {&readers::mujoco, Effect::refuses, "may refuse a moving body of such an inertia", "4.0.0, run",
     at("inertial/origin/@xyz").when(kUncertain).since({4, 0})},
    {&readers::mujoco, Effect::refuses, kBody, kRun, at("inertial/origin/@rpy").since({3, 14})},
    {&readers::mujoco, Effect::refuses, kBody, kRun, at("inertia")},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun, at("@size").when(cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun, at("@radius").when(cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun, at("@length").when(cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, "refuses a moving body of such a mass", kRun,
     at("mass/@value").when(cases::kZeroOrLess, kAlone)},
    {&readers::mujoco, Effect::changes, "reads infinity", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

}  // namespace

extern constinit const Rule sml1804_number_infinite{
    .id = "SML1804",
    .name = "number-infinite",
    .severity = Severity::error,
    .summary = "A number is infinite.",
    .remedy = "Write a large finite number, or use a continuous joint.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1804_number_infinite_file
