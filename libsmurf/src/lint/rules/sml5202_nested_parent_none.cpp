// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5202_nested_parent_none_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    const Field<std::string>& parent = use.entity.parent;
    if (!use.is_nested() || !parent || (!parent->empty() && *parent != "none")) return;
    Diagnostic& diagnostic = findings.report(
        parent.span, "MARS does not move an entity with this parent along with the include");
    diagnostic.help("leave the key out, or write `world`");
    diagnostic.label(place_of(*scene.entity(use.around)), "the scene is included here");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "does not move the entity with the include",
     "MARS SMURFLoader.cpp:667-680, run"},
};

}  // namespace

extern constinit const Rule sml5202_nested_parent_none{
    .id = "SML5202",
    .name = "nested-parent-none",
    .severity = Severity::warning,
    .summary = "An entity in an included scene has the parent `none` or an empty one.",
    .why = "The value means no parent, so the entity should move with the include.",
    .remedy = "Leave the key out, or write `world`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5202_nested_parent_none_file
