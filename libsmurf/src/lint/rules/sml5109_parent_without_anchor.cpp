// SPDX-License-Identifier: BSD-3-Clause
#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5109_parent_without_anchor_file {
namespace {

/// SML5203 reports an entity that comes before the one that it is placed on.
bool stands_on_earlier(const Use& use) {
  const std::size_t self = static_cast<std::size_t>(use.instance - use.scene.instances.data());
  return to_size(use.placement.parent.instance) < self;
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    const Entity& entity = use.entity;
    if (use.instance == nullptr || !entity.parent || entity.anchor.written) return;
    if (use.placement.parent.kind != Attachment::Kind::link) return;
    if (entity.parent->find("::") == std::string::npos || !stands_on_earlier(use)) return;
    if (slip_of(entity, "anchor") != nullptr) return;
    Diagnostic& diagnostic =
        findings.report(entity.parent.span, title(entity) + " is placed on " +
                                                quoted(*entity.parent) + ", but not fixed to it");
    const yaml::View mapping = mapping_of(use.scene.file(use.around), entity);
    diagnostic.label(place_to_add(mapping, "anchor"), "add `anchor` after this key");
    diagnostic.help("add `anchor: parent`, or `anchor: none` if it should move freely");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "waits for the parent only when `anchor` names it as well; otherwise, it creates the entity last, in file order",
     "MARS SimEntity.cpp:344-501, SMURFLoader.cpp:587-636, run"},
};

}  // namespace

extern constinit const Rule sml5109_parent_without_anchor{
    .id = "SML5109",
    .name = "parent-without-anchor",
    .severity = Severity::warning,
    .summary = "An entity has a parent, but no anchor.",
    .why =
        "`parent` says where an entity starts, not that it stays there: without `anchor: parent` "
        "it falls.",
    .remedy = "Add `anchor: parent`; to place without fixing, write `anchor: none`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5109_parent_without_anchor_file
