// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml6105_axis_zero{.id = "SML6105",
                                              .name = "ode-axis-zero",
                                              .severity = Severity::error,
                                              .summary = "A universal joint has no second axis.",
                                              .why = "MARS stops loading at such a joint.",
                                              .remedy = "Write `axis2` beside `axis`.",
                                              .sources = "MARS JointManager.cpp:82-85.",
                                              .reported_by = Tool::load_check};

}  // namespace smurf::rules
