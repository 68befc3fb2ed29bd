// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kAsserts = "reads 0, and ends the process by an assertion";

constexpr Fact kFacts[] = {
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/box/@size/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/sphere/@radius/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/cylinder/@radius/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/cylinder/@length/#underflow"},
    {&readers::dart, Effect::crashes, kAsserts, kRun, "/mesh/@scale/#underflow"},
    {&readers::urdfdom, Effect::changes, "reads 0", kRun, "#underflow"},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp (atof), run",
     "#underflow"},
    {&readers::pybullet, Effect::changes, "reads infinity", "Bullet UrdfParser.cpp (atof), run"},
    {&readers::drake, Effect::changes, "reads 0", "Drake detail_tinyxml.h:60-73", "#underflow"},
};

}  // namespace

extern constinit const Rule sml1810_overflow_underflow{
    .id = "SML1810",
    .name = "overflow-underflow",
    .severity = Severity::error,
    .summary = "A number is too large or too small for a double.",
    .remedy = "Write a number between 2.2e-308 and 1.8e308, or 0.",
    .facts = kFacts};

}  // namespace smurf::rules
