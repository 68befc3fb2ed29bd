// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4008_incomplete_value_file {

namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads what is absent as 0 or the empty text: a colour without `g` has no green, a quaternion without `w` turns by half a turn, an empty name matches nothing",
     "mars_utils Color.cpp:28-34, run; configmaps, run"},
};

}  // namespace

extern constinit const Rule sml4008_incomplete_value{.id = "SML4008",
                                                     .name = "incomplete-value",
                                                     .severity = Severity::warning,
                                                     .summary = "A value is incomplete.",
                                                     .remedy = "Write the whole value.",
                                                     .facts = kFacts};

}  // namespace smurf::rules::sml4008_incomplete_value_file
