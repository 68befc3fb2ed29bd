// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml4003_out_of_range_file {
namespace {

constexpr std::string_view kMakesRoom = "makes room for as many values, and ends";

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, "/sensors/width/#negative"},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, "/sensors/height/#negative"},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, "/sensors/bands/#negative"},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, "/sensors/lasers/#negative"},
    {&readers::mars, Effect::changes, "uses the number as it is", "MARS MotorData.cpp and others"},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

}  // namespace

extern constinit const Rule sml4003_out_of_range{
    .id = "SML4003",
    .name = "out-of-range",
    .severity = Severity::error,
    .summary = "A number lies outside what its key allows.",
    .remedy = "Write a number within the bounds of the message.",
    .facts = kFacts};

}  // namespace smurf::rules::sml4003_out_of_range_file
