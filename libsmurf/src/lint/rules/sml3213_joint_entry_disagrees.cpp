// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3213_joint_entry_disagrees_file {
namespace {

void check_text(const Field<std::string>& in_urdf, const std::optional<Spanned<std::string>>& here,
                std::string_view key, const urdf::Joint& joint, Findings& findings) {
  if (!in_urdf || !here || here->value == *in_urdf) return;
  Diagnostic& diagnostic = findings.report(
      here->span, quoted(key) + " of " + title(joint) + " is " + quoted(here->value) +
                      " here, but " + quoted(*in_urdf) + " in the URDF");
  diagnostic.label(in_urdf.span, "in the URDF");
}

/// A joint type of the physics engine that has other degrees of freedom than the URDF's.
bool is_other_kind(std::string_view type, urdf::JointType in_urdf) {
  const bool is_hinge = type == "hinge" || type == "1";
  const bool is_slider = type == "slider" || type == "3";
  const bool turns = in_urdf == urdf::JointType::revolute || in_urdf == urdf::JointType::continuous;
  return (is_hinge && in_urdf == urdf::JointType::prismatic) || (is_slider && turns);
}

void check(const LinkedModel& model, Findings& findings) {
  for (const JointAnnotation& entry : model.annotations.joints) {
    const urdf::Joint* joint = entry.name ? model.find_joint(*entry.name) : nullptr;
    if (joint == nullptr) continue;
    const yaml::View mapping = mapping_of(model, entry);
    const auto parent = text_at(mapping, "parent");
    const auto child = text_at(mapping, "child");
    // Another rule reports unknown links.
    if (parent && model.link_names.contains(parent->value)) {
      check_text(joint->parent, parent, "parent", *joint, findings);
    }
    if (child && model.link_names.contains(child->value)) {
      check_text(joint->child, child, "child", *joint, findings);
    }
    check_text(joint->type_name, text_at(mapping, "joint_type"), "joint_type", *joint, findings);
    if (entry.type && is_other_kind(*entry.type, joint->type)) {
      check_text(joint->type_name, text_at(mapping, "type"), "type", *joint, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "builds the joint that the entry describes",
     "MARS smurf.cpp:391-403, 893-939"},
    {&readers::phobos, Effect::changes, "keeps what it read last",
     "Phobos representation.py:2001-2119"},
};

}  // namespace

extern constinit const Rule sml3213_joint_entry_disagrees{
    .id = "SML3213",
    .name = "joint-entry-disagrees",
    .severity = Severity::warning,
    .summary = "An entry of `joint` contradicts the URDF.",
    .why = "Readers of the URDF ignore the entry.",
    .remedy = "Make the two agree.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3213_joint_entry_disagrees_file
