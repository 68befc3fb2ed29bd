// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_map>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check_list(const Field<NameList>& list, const Subject& who, Findings& findings) {
  if (!list || list->size() < 2) return;
  std::unordered_map<std::string_view, Span> first;
  for (const Spanned<std::string>& name : *list) {
    const auto [found, is_new] = first.emplace(name.value, name.span);
    if (is_new) continue;
    findings.report(name.span, who + " lists " + quoted(name.value) + " twice")
        .labels.push_back({found->second, "listed here"});
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

}  // namespace

extern constinit const Rule sml3121_repeated_name{
    .id = "SML3121",
    .name = "repeated-name",
    .severity = Severity::warning,
    .summary = "A list of names holds one name twice.",
    .why = "MARS puts the value of the sensor, joint or motor into the data twice, so that all "
           "later values are found one place too late; Phobos refuses to export a joint that "
           "submechanisms list twice.",
    .remedy = "Take one of the two out, or write the name that was meant.",
    .sources = "MARS smurf.cpp:151-182, 465-480; Phobos core/robot.py:352-360.",
    .check_model = check};

}  // namespace smurf::rules
