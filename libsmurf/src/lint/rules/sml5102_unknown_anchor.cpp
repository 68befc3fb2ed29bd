// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5102_unknown_anchor_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "fixes the entity to the world",
     "MARS SimEntity.cpp:447-481"},
    {&readers::mars2, Effect::changes, "fixes the entity to a frame of that name",
     "MarsSceneLoader.cpp:361-397"},
    {&readers::phobos, Effect::loses, "keeps the name, and stops when it assembles the scene",
     kRun},
};

}  // namespace

extern constinit const Rule sml5102_unknown_anchor{
    .id = "SML5102",
    .name = "unknown-anchor",
    .severity = Severity::error,
    .summary = "`anchor` is not none, world, parent, or a link of the scene.",
    .why = "The text may be `None`, `false` or a misspelt entity.",
    .remedy = "Write `none`, `world`, `parent` or `ENTITY::LINK`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5102_unknown_anchor_file
