// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4002_unknown_value_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::refuses, "ends with an uncaught exception", kRun, at("physicmode")},
    {&readers::mars, Effect::refuses, "ends with an uncaught exception",
     "MARS NodeData.cpp:71-95, run with graphics that print", at("visualType")},
    {&readers::mars, Effect::breaks,
     "stops loading here, so all later objects, the pose and the anchor are missing",
     "MARS SensorManager.cpp:357-360"},
};

}  // namespace

extern constinit const Rule sml4002_unknown_value{
    .id = "SML4002",
    .name = "unknown-value",
    .severity = Severity::error,
    .summary = "The value of a key is not one of the known words.",
    .remedy = "Use one of the known values; they are case-sensitive.",
    .facts = kFacts};

}  // namespace smurf::rules::sml4002_unknown_value_file
