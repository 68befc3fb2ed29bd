// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5103_parent_of_scene_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "places the entity in the world frame with a message",
     "MARS SimEntity.cpp:371-390"},
};

}  // namespace

extern constinit const Rule sml5103_parent_of_scene{
    .id = "SML5103",
    .name = "parent-of-scene",
    .severity = Severity::error,
    .summary = "`parent` or `anchor` names an included scene.",
    .why = "An included scene is not an entity.",
    .remedy = "Name an entity inside the included scene and one of its links.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5103_parent_of_scene_file
