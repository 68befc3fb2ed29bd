// SPDX-License-Identifier: BSD-3-Clause
#include <initializer_list>
#include <utility>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4113_minimum_above_maximum_file {
namespace {

/// `lower` and `upper` of one entry.
void check_pair(yaml::View mapping, std::string_view lower, std::string_view upper,
                Findings& findings) {
  const auto low = number_at(mapping, lower);
  const auto high = number_at(mapping, upper);
  if (!low || !high || *low <= *high) return;
  const yaml::View place = mapping.find(lower);
  Diagnostic& diagnostic = findings.report(
      place.span(), quoted(lower) + " is " + format_number(*low) + ", which is more than " +
                        quoted(upper) + ", " + format_number(*high));
  diagnostic.label(mapping.find(upper).span(), "the upper bound");
}

template <class Entries>
void check_entries(const LinkedModel& model, const Entries& entries,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> pairs,
                   Findings& findings) {
  for (const auto& entry : entries) {
    const yaml::View mapping = mapping_of(model, entry);
    for (const auto& [lower, upper] : pairs) check_pair(mapping, lower, upper, findings);
  }
}

/// Bounds that are equal.
void check_ranges(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    const Field<double>& low = lower_bound(motor);
    const Field<double>& high = upper_bound(motor);
    if (!low || !high || *low != *high) continue;
    if (control_in_mars(motor) != MotorControl::position) continue;
    Diagnostic& diagnostic =
        findings.report(low.span, subject("motor", motor) + " cannot move: both its bounds are " +
                                      format_number(*low));
    diagnostic.severity = Severity::warning;
    diagnostic.label(high.span, "the upper bound");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  check_entries(model, all.motors, {{"minValue", "maxValue"}, {"minPosition", "maxPosition"}},
                findings);
  check_entries(model, all.sensors, {{"min_distance", "max_distance"}}, findings);
  check_entries(model, all.joints,
                {{"lowStopAxis1", "highStopAxis1"},
                 {"lowStopAxis2", "highStopAxis2"},
                 {"minPosition", "maxPosition"}},
                findings);
  check_ranges(model, findings);
  check_entries(model, all.graphics, {{"fogStart", "fogEnd"}}, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "clamps commands to the upper bound, then to the lower one: the motor always goes to the "
     "lower bound",
     "MARS SimMotor.cpp (runPositionController), GraphicData.cpp, RotatingRaySensor.cpp"},
    {&readers::phobos, Effect::takes, "uses the limits of the joint", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml4113_minimum_above_maximum{
    .id = "SML4113",
    .name = "minimum-above-maximum",
    .severity = Severity::error,
    .summary = "A lower bound is above the upper bound, or both bounds of a motor are equal.",
    .why = "Swapped stops, distances or fog limits leave no range.",
    .remedy = "Swap the two.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml4113_minimum_above_maximum_file
