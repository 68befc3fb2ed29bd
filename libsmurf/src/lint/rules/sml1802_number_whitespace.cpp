// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1802_number_whitespace_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "skips leading white space", kRun, when(cases::kLeading)},
    {&readers::pybullet, Effect::takes, "skips white space", "Bullet UrdfParser.cpp (atof), run",
     when(cases::kEnoughWords)},
    {&readers::pybullet, Effect::refuses, "refuses an axis that is not a vector", kRun, at("axis")},
    {&readers::pybullet, Effect::changes, "reads a vector of zeros and warns",
     "Bullet UrdfParser.cpp:49-78, run"},
    {&readers::mujoco, Effect::takes, "skips white space", kRun},
    {&readers::drake, Effect::takes, "skips white space", kRun, when(cases::kEnoughRead)},
    {&readers::drake, Effect::refuses, "takes a scale without a space for one number", kRun},
    {&readers::phobos, Effect::takes, "skips white space", kRun},
};

}  // namespace

extern constinit const Rule sml1802_number_whitespace{
    .id = "SML1802",
    .name = "number-whitespace",
    .severity = Severity::error,
    .summary =
        "White space follows a single number, or a tab or line break separates those of a vector.",
    .why = "A mass written like this can cost all visuals and collisions of its link without a "
           "message.",
    .remedy = "Delete the white space, and separate the numbers of a vector by single spaces.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1802_number_whitespace_file
