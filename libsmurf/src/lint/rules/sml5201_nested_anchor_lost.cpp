// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5201_nested_anchor_lost_file {
namespace {

std::string words(const LinkedScene& scene, const Attachment& anchor) {
  switch (anchor.kind) {
  case Attachment::Kind::none: return "`none`";
  case Attachment::Kind::world: return "`world`";
  case Attachment::Kind::link: break;
  }
  return quoted(scene.instance(anchor.instance).name + "::" + anchor.link);
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    const Field<std::string>& anchor = use.entity.anchor;
    if (!anchor || anchor->empty() || !use.inherits_in_mars() || use.is_member()) return;
    const Placement& around = use.around.placement;
    if (!around.is_known || use.placement.anchor == around.anchor) return;
    Diagnostic& diagnostic =
        findings.report(anchor.span, "MARS replaces this anchor by that of the include, which is " +
                                         words(use.scene, around.anchor));
    const Entity& including = *scene.entity(use.around);
    diagnostic.label(including.anchor.written ? including.anchor.span : place_of(including),
                     "the scene is included here");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "gives the entity the anchor of the include",
     "MARS SMURFLoader.cpp:671-675, run"},
};

}  // namespace

extern constinit const Rule sml5201_nested_anchor_lost{
    .id = "SML5201",
    .name = "nested-anchor-lost",
    .severity = Severity::warning,
    .summary = "An entity in an included scene has an anchor that MARS overwrites.",
    .why = "An entity that is fixed in its own scene comes loose. This tool keeps the anchor.",
    .remedy = "Set `anchor` on the entity that includes the scene, or place the anchored entities "
              "in the outer scene.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5201_nested_anchor_lost_file
