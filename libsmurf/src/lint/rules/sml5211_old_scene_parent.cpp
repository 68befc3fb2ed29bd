// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5211_old_scene_parent_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (use.instance == nullptr || !is_old_scene(use.instance->type)) return;
    const bool by_parent = use.placement.parent.kind == Attachment::Kind::link;
    if (!by_parent && use.placement.anchor.kind != Attachment::Kind::link) return;
    const Attachment& target = by_parent ? use.placement.parent : use.placement.anchor;
    const Instance& created_later = scene.instance(target.instance);
    const Field<std::string>& own = by_parent ? use.entity.parent : use.entity.anchor;
    const bool is_own = own && own->find("::") != std::string::npos;
    if (!is_own || is_old_scene(created_later.type)) return;
    Diagnostic& diagnostic = findings.report(own.span, "MARS creates this old scene before " +
                                                           quoted(created_later.name));
    diagnostic.label(place_of(scene.entity(created_later)), "created later");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "creates old scenes (scn, scene, yml) while it parses the file, before any model, and "
     "therefore does not find the link; places the old scene in the world frame and anchors it to "
     "the world",
     "MARS SMURFLoader.cpp:337-349, 580-637; SimEntity.cpp:371-390"},
};

}  // namespace

extern constinit const Rule sml5211_old_scene_parent{
    .id = "SML5211",
    .name = "old-scene-parent",
    .severity = Severity::error,
    .summary = "An old MARS scene is placed on, or anchored to, a model.",
    .remedy = "Place it relative to the world, or turn it into a model.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5211_old_scene_parent_file
