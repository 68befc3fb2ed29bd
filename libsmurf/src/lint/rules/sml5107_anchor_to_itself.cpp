// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5107_anchor_to_itself_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "blocks every joint between the two links",
     "MARS SimEntity.cpp:447-481"},
};

}  // namespace

extern constinit const Rule sml5107_anchor_to_itself{
    .id = "SML5107",
    .name = "anchor-to-itself",
    .severity = Severity::error,
    .summary = "An entity is anchored to one of its own links.",
    .remedy = "Anchor the entity to the world or to another entity.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5107_anchor_to_itself_file
