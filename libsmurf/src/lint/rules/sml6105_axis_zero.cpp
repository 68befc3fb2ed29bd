// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6105_axis_zero_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::refuses, "stops loading at the joint", "MARS JointManager.cpp:82-85"},
};

}  // namespace

extern constinit const Rule sml6105_axis_zero{.id = "SML6105",
                                              .name = "ode-axis-zero",
                                              .severity = Severity::error,
                                              .summary = "A universal joint has no second axis.",
                                              .remedy = "Write `axis2` beside `axis`.",
                                              .facts = kFacts,
                                              .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6105_axis_zero_file
