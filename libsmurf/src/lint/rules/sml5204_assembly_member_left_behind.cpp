// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5204_assembly_member_left_behind_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (!use.inherits_in_mars() || !use.is_member()) return;
    if (use.around.placement.parent.kind != Attachment::Kind::link) return;
    const bool is_meant = use.entity.root.written && !use.entity.root;
    if (is_meant || slip_of(use.entity, "root") != nullptr) return;  // reported
    Diagnostic& diagnostic =
        findings.report(place_of(use.entity),
                        title(use.entity) + " is not a root of the assembly, so MARS leaves it "
                                            "in the world frame");
    diagnostic.label(place_of(*scene.entity(use.around)), "the assembly is included here");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "places the entity in the world frame",
     "MARS SMURFLoader.cpp:667-680"},
};

}  // namespace

extern constinit const Rule sml5204_assembly_member_left_behind{
    .id = "SML5204",
    .name = "assembly-member-left-behind",
    .severity = Severity::warning,
    .summary = "A member of an included assembly has neither a parent nor `root: true`.",
    .why = "This tool places it in the frame of the include.",
    .remedy = "Give the member a parent inside the assembly, or mark it as `root: true`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5204_assembly_member_left_behind_file
