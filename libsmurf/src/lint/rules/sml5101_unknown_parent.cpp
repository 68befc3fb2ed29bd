// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5101_unknown_parent_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "places the entity in the world frame with a message",
     "MARS SimEntity.cpp:371-390"},
    {&readers::phobos, Effect::loses, "keeps the name, and stops when it assembles the scene",
     kRun},
};

}  // namespace

extern constinit const Rule sml5101_unknown_parent{
    .id = "SML5101",
    .name = "unknown-parent",
    .severity = Severity::error,
    .summary = "`parent` names a frame that the scene does not have.",
    .remedy =
        "Write `ENTITY::LINK` with the name of an entity and of a link of its model, or leave "
        "the key out for the world.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5101_unknown_parent_file
