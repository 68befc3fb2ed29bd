// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5106_world_case_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "looks for an entity of that name",
     "MARS SimEntity.cpp:368-371"},
    {&readers::phobos, Effect::takes, "writes WORLD and means the world",
     "Phobos multiple.py:20,126"},
};

}  // namespace

extern constinit const Rule sml5106_world_case{
    .id = "SML5106",
    .name = "world-case",
    .severity = Severity::warning,
    .summary = "`world` or `none` is written with capital letters.",
    .remedy = "Write `world` or `none`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5106_world_case_file
