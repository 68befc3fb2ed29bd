// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3121_repeated_name_file {
namespace {

void check_list(const Field<NameList>& list, const Subject& who, Findings& findings) {
  if (!list || list->size() < 2) return;
  NameTable names;
  for (std::uint32_t i = 0; i < list->size(); ++i) {
    const Spanned<std::string>& name = (*list)[i];
    const auto first = names.add(name.value, i);
    if (!first) continue;
    findings.report(name.span, who + " lists " + quoted(name.value) + " twice")
        .label((*list)[*first].span, "listed here");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    for (const auto* list :
         {&sensor.id, &sensor.links, &sensor.joints, &sensor.motors, &sensor.collisions}) {
      check_list(*list, subject("sensor", sensor), findings);
    }
  }
  for (const Controller& controller : model.annotations.controllers) {
    check_list(controller.sensors, subject("controller", controller), findings);
    check_list(controller.motors, subject("controller", controller), findings);
  }
  for (const Submechanism& mechanism : model.annotations.submechanisms) {
    const Subject who = subject("submechanism", mechanism);
    for (const auto* list : {&mechanism.joint_names, &mechanism.joint_names_spanning_tree,
                             &mechanism.joint_names_active, &mechanism.joint_names_independent}) {
      check_list(*list, who, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "puts the value of the sensor, joint or motor into the data twice, so all later values are "
     "shifted by one place",
     "MARS smurf.cpp:151-182, 465-480"},
    {&readers::phobos, Effect::loses, "does not export a joint that submechanisms list twice",
     "Phobos core/robot.py:352-360"},
};

}  // namespace

extern constinit const Rule sml3121_repeated_name{.id = "SML3121",
                                                  .name = "repeated-name",
                                                  .severity = Severity::warning,
                                                  .summary =
                                                      "A list of names has the same name twice.",
                                                  .remedy = "Remove one of the two, or correct it.",
                                                  .check_model = check,
                                                  .facts = kFacts};

}  // namespace smurf::rules::sml3121_repeated_name_file
