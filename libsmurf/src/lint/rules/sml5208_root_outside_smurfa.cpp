// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5208_root_outside_smurfa_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.root.value_or(false) || entity.list == EntityList::smurfa) return;
    findings.report(entity.root.span, "`root` has no effect outside a list `smurfa`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores, "reads `root` in a list `smurfa` only",
     "MARS SMURFLoader.cpp:444-450"},
};

}  // namespace

extern constinit const Rule sml5208_root_outside_smurfa{
    .id = "SML5208",
    .name = "root-outside-smurfa",
    .severity = Severity::warning,
    .summary = "`root: true` is in a list other than `smurfa`.",
    .remedy = "Rename the list to `smurfa`, or delete the key.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5208_root_outside_smurfa_file
