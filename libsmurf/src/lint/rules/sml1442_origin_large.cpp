// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers.hpp"
#include "lint/body.hpp"
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// The unit is one decision, so one finding a file.
void check(const LinkedModel& model, Findings& findings) {
  const double far = findings.tolerance();
  if (!model.robot) return;
  Habit habit;
  double first = 0;
  for (const xml::Element& element : model.robot->document.elements) {
    if (element.name != "origin") continue;
    for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
      const xml::Attribute& attribute =
          model.robot->document.attributes[element.first_attribute + i];
      if (attribute.name != "xyz") continue;
      double farthest = 0;
      for (const double value : numbers_in(attribute.value)) {
        if (std::fabs(value) > std::fabs(farthest)) farthest = value;
      }
      if (std::fabs(farthest) <= far) continue;
      if (habit.is_first()) first = farthest;
      habit.add(attribute.value_span, "this origin lies " + format_rounded(std::fabs(farthest)) +
                                          " m away; are millimetres meant?");
    }
  }
  if (Diagnostic* diagnostic = habit.report("such origins", findings)) {
    diagnostic->help = format_rounded(first) + " mm are " + format_rounded(first / 1000) + " m";
  }
}

}  // namespace

extern constinit const Rule sml1442_origin_large{
    .id = "SML1442",
    .name = "origin-large",
    .severity = Severity::warning,
    .summary = "An origin lies more than 10 m away.",
    .why = "URDF lengths are metres: values in millimetres put a part hundreds of metres off, out "
           "of sight in every viewer.",
    .remedy = "Divide by 1000, if it is in millimetres.",
    .sources = "URDF specification; urdfdom pose.h.",
    .check_model = check,
    .tolerance = {.value = kFarthestOrigin,
                  .unit = "m",
                  .meaning = "how far a part may lie from the frame it is placed in"}};

}  // namespace smurf::rules
