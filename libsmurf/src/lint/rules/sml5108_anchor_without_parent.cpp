// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (!use.entity.anchor || *use.entity.anchor != "parent") return;
    if (!use.placement.is_known || use.placement.parent.kind != Attachment::Kind::none) return;
    // `WORLD`, and a key that is nearly `parent`, are reported.
    if (use.entity.parent.written && *use.entity.parent != "world") return;
    if (!use.entity.parent.written && slip_of(use.entity, "parent") != nullptr) return;
    Diagnostic& diagnostic = findings.report(
        use.entity.anchor.span, title(use.entity) + " is anchored to its parent, but has none");
    diagnostic.help = "write `world` if that is meant";
    const Field<std::string>& file = use.entity.file;
    if (!use.entity.parent.written && file.written) {
      diagnostic.labels.push_back({file.span, "no `parent` follows"});
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "fixes the entity to the world",
     "MARS SimEntity.cpp:452-453"},
};

}  // namespace

extern constinit const Rule sml5108_anchor_without_parent{
    .id = "SML5108",
    .name = "anchor-without-parent",
    .severity = Severity::warning,
    .summary = "`anchor: parent` stands on an entity that has no parent.",
    .remedy = "Add `parent`, or write `anchor: world`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules
