// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3109_unknown_pose_joint_file {
namespace {

/// The mapping whose key it is.
yaml::View siblings_of(const LinkedModel& model, const Reference& key) {
  const yaml::Document& document = *model.document(key.span.source);
  return {document, document.nodes[key.place].parent};
}

void check(const LinkedModel& model, Findings& findings) {
  if (!can_judge(model, NameKind::motor)) return;
  for (const Reference& one : findings.answers().doubtful_references()) {
    if (one.is_known()) continue;
    const AnnotationPlace place = annotation_place(model, one);
    if (place.section != "poses") continue;
    Diagnostic* diagnostic = check_reference(model, NameKind::joint, one.name, place_of(one),
                                             subject_of(place).c_str(), findings);
    if (diagnostic == nullptr || one.notation != Reference::Notation::yaml_key) continue;
    const yaml::View siblings = siblings_of(model, one);
    std::erase_if(diagnostic->fixes,
                  [&](const Fix& fix) { return bool(siblings.find(fix.edits.front().text)); });
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "looks the names up among the motors, and does nothing for an unknown one",
     "MARS SimEntity.cpp:505-511"},
    {&readers::phobos, Effect::breaks, "looks the names up among the joints", "Phobos io/poses.py"},
};

}  // namespace

extern constinit const Rule sml3109_unknown_pose_joint{
    .id = "SML3109",
    .name = "unknown-pose-joint",
    .severity = Severity::error,
    .summary = "A joint pose names neither a motor nor a joint of the model.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3109_unknown_pose_joint_file
