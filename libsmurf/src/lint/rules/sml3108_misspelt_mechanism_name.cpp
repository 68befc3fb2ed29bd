// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check_name(const LinkedModel& model, NameKind kind, const Spanned<std::string>& name,
                const Subject& who, Findings& findings) {
  if (!is_slip(model, kind, name.value)) return;
  check_reference(model, kind, name.value, name.span, who, findings);
}

void check_list(const LinkedModel& model, const Field<NameList>& list, const Subject& who,
                Findings& findings) {
  if (!list) return;
  for (const Spanned<std::string>& name : *list) {
    check_name(model, NameKind::joint, name, who, findings);
  }
}

void check_loops(const LinkedModel& model, const Submechanism& entry, const Subject& who,
                 Findings& findings) {
  const yaml::View loops = mapping_of(model, entry).find("loop_constraints");
  if (!loops || !loops.is_sequence()) return;
  for (const yaml::View loop : loops) {
    for (const std::string_view key : {"predecessor_body", "successor_body"}) {
      if (const auto body = text_at(loop, key)) {
        check_name(model, NameKind::link, *body, who, findings);
      }
    }
    if (const auto joint = text_at(loop, "cut_joint")) {
      check_name(model, NameKind::joint, *joint, who, findings);
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Submechanism& entry : model.annotations.submechanisms) {
    const Subject who("submechanism", entry.contextual_name);
    for (const Field<NameList>* list :
         {&entry.joint_names, &entry.joint_names_spanning_tree, &entry.joint_names_active,
          &entry.joint_names_independent}) {
      check_list(model, *list, who, findings);
    }
    check_loops(model, entry, who, findings);
  }
  for (const Exoskeleton& entry : model.annotations.exoskeletons) {
    const Subject who("exoskeleton", entry.contextual_name);
    for (const Field<NameList>* list :
         {&entry.joint_names, &entry.joint_names_spanning_tree, &entry.joint_names_dependent}) {
      check_list(model, *list, who, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses,
     "looks the names up in the URDF, and stops with an exception",
     "Phobos io/hyrodyn.py, core/robot.py:352-360, run"},
};

}  // namespace

extern constinit const Rule sml3108_misspelt_mechanism_name{
    .id = "SML3108",
    .name = "misspelt-mechanism-name",
    .severity = Severity::warning,
    .summary = "A submechanism or exoskeleton names what is nearly a joint or link of the "
               "URDF.",
    .why =
        "Names that are altogether unknown are left alone: the joints of a floating base need not be in the URDF.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
