// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4003_out_of_range_file {
namespace {

constexpr std::string_view kMakesRoom = "makes room for as many values, and ends";

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, at("sensors/width").when(cases::kNegative)},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun,
     at("sensors/height").when(cases::kNegative)},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun, at("sensors/bands").when(cases::kNegative)},
    {&readers::mars, Effect::refuses, kMakesRoom, kRun,
     at("sensors/lasers").when(cases::kNegative)},
    {&readers::mars, Effect::changes, "uses the number as it is", "MARS MotorData.cpp and others"},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

}  // namespace

extern constinit const Rule sml4003_out_of_range{.id = "SML4003",
                                                 .name = "out-of-range",
                                                 .severity = Severity::error,
                                                 .summary =
                                                     "A number lies outside what its key allows.",
                                                 .remedy = "Write a number that the key allows.",
                                                 .facts = kFacts};

}  // namespace smurf::rules::sml4003_out_of_range_file
