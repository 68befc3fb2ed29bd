// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5003_zero_quaternion_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends the process when ODE normalises it", "ODE, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5003_zero_quaternion{
    .id = "SML5003",
    .name = "zero-quaternion",
    .severity = Severity::error,
    .summary = "A rotation is a quaternion of length zero.",
    .why = "It defines no rotation.",
    .remedy = "Write a unit quaternion; the identity rotation is [1, 0, 0, 0].",
    .facts = kFacts};

}  // namespace smurf::rules::sml5003_zero_quaternion_file
