// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1803_number_nan_file {
namespace {

constexpr std::string_view kBody = "refuses a moving body of such an inertia";
constexpr std::string_view kRuns = "2.3.7, 3.3.7 and 4.0.0, run";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "computes with it until nothing has a position",
     "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::refuses, "refuses the size", "3.2.0, run",
     at("mesh/@scale").before({3, 2, 3})},
    {&readers::mujoco, Effect::refuses, "refuses more numbers than it expects", kRun,
     when(cases::kTooMany)},
    {&readers::mujoco, Effect::refuses, "refuses fewer numbers than it expects", kRun,
     when(cases::kTooFew)},
    {&readers::mujoco, Effect::refuses, "cannot read such a word as a scale", kRun,
     when(cases::kLongWord)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "3.1.3, run",
     at("inertia/@ixz").when(kCarried).unless(kStill).before({3, 1, 5})},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "3.1.3, run",
     at("inertia/@izz").when(kCarried).unless(kStill).before({3, 1, 5})},
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
    {&readers::mujoco, Effect::changes, "computes with it where other bodies move with it",
     "3.3.7, run", at("inertia/@ixx").unless(kAlone).before({3, 14})},
    {&readers::mujoco, Effect::changes, "computes with it where other bodies move with it",
     "3.2.3, run", at("mass").unless(kAlone).before({3, 2, 4})},
    {&readers::mujoco, Effect::refuses, kBody, "3.13.0, run", at("inertia").before({3, 14})},
    {&readers::mujoco, Effect::refuses, kBody, kRun, at("inertial/origin/@rpy").since({3, 14})},
    {&readers::mujoco, Effect::refuses, "refuses a moving body of such a mass", kRun, at("mass")},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without inertia", kRun,
     at("inertia").when(kAlone)},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, at("sphere")},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, at("cylinder")},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, at("box")},
    {&readers::mujoco, Effect::changes, "reads it, and computes with it", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

}  // namespace

extern constinit const Rule sml1803_number_nan{
    .id = "SML1803",
    .name = "number-nan",
    .severity = Severity::error,
    .summary = "A number is `nan`.",
    .why = "urdf-loader computes with it until nothing in the simulation has a position.",
    .remedy = "Write the number that was meant; look at the exporter that wrote it.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1803_number_nan_file
