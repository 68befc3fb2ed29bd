// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5108_anchor_without_parent_file {
namespace {

constexpr Circumstance kParent{"parent"};

/// A link as anchor: many authors expect it to place the entity there.
void check_link(const Use& use, Findings& findings) {
  const Entity& entity = use.entity;
  if (entity.parent.written || use.placement.anchor.kind != Attachment::Kind::link) return;
  Diagnostic& diagnostic = findings.report(
      entity.anchor.span, title(entity) + " is fixed to " + quoted(*entity.anchor) +
                              ", but its position is relative to the origin of the scene");
  diagnostic.help("write " + quoted("parent: " + *entity.anchor) +
                  " to place it there, or `parent: world` if the origin is meant");
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (!use.entity.anchor) return;
    if (!use.placement.is_known || use.placement.parent.kind != Attachment::Kind::none) return;
    // `WORLD`, and a key that is nearly `parent`, are reported.
    if (use.entity.parent.written && *use.entity.parent != "world") return;
    if (!use.entity.parent.written && slip_of(use.entity, "parent") != nullptr) return;
    if (*use.entity.anchor != "parent") return check_link(use, findings);
    Diagnostic& diagnostic = findings.report(
        use.entity.anchor.span, title(use.entity) + " is anchored to its parent, but has none");
    diagnostic.when(kParent);
    diagnostic.help("write `world` if that is meant");
    const Field<std::string>& file = use.entity.file;
    if (!use.entity.parent.written && file.written) {
      diagnostic.label(file.span, "no `parent` follows");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "fixes the entity to the world", "MARS SimEntity.cpp:452-453",
     when(kParent)},
};

}  // namespace

extern constinit const Rule sml5108_anchor_without_parent{
    .id = "SML5108",
    .name = "anchor-without-parent",
    .severity = Severity::warning,
    .summary = "An entity has an anchor to its parent or to a link, but no parent.",
    .why =
        "`anchor` fixes an entity where it is. Only `parent` places it on a link: without it, the "
        "entity starts at its position in the scene.",
    .remedy = "Add `parent`, or write `anchor: world`; `parent: world` states that the position is "
              "relative to the scene.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5108_anchor_without_parent_file
