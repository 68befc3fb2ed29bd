// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {

namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "reads a colour of three numbers as black",
     "urdfdom color.h:88, run"},
    {&readers::mujoco, Effect::refuses, "refuses the number", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", "Drake, read"},
};

}  // namespace

extern constinit const Rule sml1706_rgba_count{
    .id = "SML1706",
    .name = "rgba-count",
    .severity = Severity::error,
    .summary = "A colour does not have four numbers.",
    .remedy = "Write red, green, blue and alpha, each from 0 to 1; an alpha of 1 is opaque.",
    .facts = kFacts};

}  // namespace smurf::rules
