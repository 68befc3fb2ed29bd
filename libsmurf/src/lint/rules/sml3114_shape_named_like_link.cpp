// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3114_shape_named_like_link_file {
namespace {

constexpr std::string_view kInertial = "inertial_";

/// The link that has this name in MARS, or whose inertial has it.
const urdf::Link* namesake(const LinkedModel& model, std::string_view name) {
  if (const urdf::Link* link = model.find_link(name)) return link;
  if (!name.starts_with(kInertial)) return nullptr;
  const urdf::Link* link = model.find_link(name.substr(kInertial.size()));
  return link != nullptr && link->inertial ? link : nullptr;
}

void check_shape(const LinkedModel& model, const Field<std::string>& name, std::string_view kind,
                 Findings& findings) {
  const urdf::Link* link = name ? namesake(model, *name) : nullptr;
  if (link == nullptr) return;
  const bool is_inertial = *link->name != *name;
  Diagnostic& diagnostic = findings.report(
      name.span, "MARS attaches what belongs to " +
                     std::string(is_inertial ? "the inertial of " : "") + title(*link) +
                     " to the " + std::string(kind) + " of the same name");
  diagnostic.label(link->name.span, "the link");
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;  // readers of plain URDFs do not mind
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      check_shape(model, visual.name, "visual", findings);
    }
    for (const urdf::Collision& collision : link.collisions) {
      check_shape(model, collision.name, "collision", findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "keeps links and their inertials, collisions and visuals in one map of names, and the last "
     "one wins: joints and sensors of the link are attached to the shape, or the loading stops",
     "MARS smurf.cpp:619-620, 661, 715, 788, 899-900"},
};

}  // namespace

extern constinit const Rule sml3114_shape_named_like_link{
    .id = "SML3114",
    .name = "shape-named-like-link",
    .severity = Severity::error,
    .summary = "A visual or collision has the name of a link.",
    .remedy = "Rename the shape.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3114_shape_named_like_link_file
