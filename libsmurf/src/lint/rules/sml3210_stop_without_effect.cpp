// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3210_stop_without_effect_file {
namespace {

constexpr double kLeastSpring = 1e-8;

void check_axis(const JointAnnotation& joint, yaml::View mapping, const std::string& axis,
                Findings& findings) {
  const auto high = number_at(mapping, "highStopAxis" + axis);
  const double low = number_at(mapping, "lowStopAxis" + axis).value_or(0);
  const double spring = number_at(mapping, "spring_const_constraint_axis" + axis).value_or(0);
  if (!high || *high == 0 || low != 0 || spring > kLeastSpring) return;
  if (has_misspelt(mapping, "lowStopAxis" + axis) && !mapping.find("lowStopAxis" + axis)) return;
  const yaml::View place = mapping.find("highStopAxis" + axis);
  Diagnostic& diagnostic =
      findings.report(place.key_span(),
                      "MARS sets no stop of " + subject("joint", joint) + ": its lower stop is 0");
  if (const yaml::View written = mapping.find("lowStopAxis" + axis)) {
    diagnostic.label(written.span(), "the lower stop");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const JointAnnotation& joint : model.annotations.joints) {
    const yaml::View mapping = mapping_of(model, joint);
    if (!mapping) continue;
    check_axis(joint, mapping, "1", findings);
    check_axis(joint, mapping, "2", findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "sets the stops of a joint only when `lowStopAxis1` is not 0 or there is a spring: with a lower stop of 0 the joint turns freely",
     "MARS JointPhysics.cpp:332-347, 407-420, run"},
};

}  // namespace

extern constinit const Rule sml3210_stop_without_effect{
    .id = "SML3210",
    .name = "stop-without-effect",
    .severity = Severity::error,
    .summary = "A joint has an upper stop that MARS does not set.",
    .remedy = "Give `lowStopAxis1` a value that is nearly 0, such as -0.000001.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3210_stop_without_effect_file
