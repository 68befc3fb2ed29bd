// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <optional>

#include "base/numbers/numbers.hpp"
#include "base/text/suggest.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3518_srdf_joint_property_file {
namespace {

constexpr std::array<std::string_view, 2> kProperties = {"motion_model", "angular_distance_weight"};
constexpr std::array<std::string_view, 2> kModels = {"holonomic", "diff_drive"};

bool is_one(std::string_view text, std::span<const std::string_view> known) {
  return std::find(known.begin(), known.end(), text) != known.end();
}

void check_property(const srdf::JointProperty& one, Findings& findings) {
  if (!one.property || !one.value) return;
  if (!is_one(*one.property, kProperties)) {
    // Other programs have properties of their own.
    const auto near = only_nearest(*one.property, kProperties);
    if (!near) return;
    Diagnostic& found = findings.report(one.property.span, "MoveIt does not know the property " +
                                                               quoted(*one.property));
    found.help("did you mean " + quoted(*near) + "?");
    found.fixes.push_back({Applicability::unsafe, {{one.property.span, std::string(*near)}}});
  } else if (*one.property == "motion_model" && !is_one(*one.value, kModels)) {
    findings.report(one.value.span, quoted(*one.value) + " is not a motion model of MoveIt")
        .help("write holonomic or diff_drive");
  } else if (*one.property == "angular_distance_weight" && !parse_number(*one.value)) {
    findings.report(one.value.span, quoted(*one.value) + " is not a number")
        .help("write a number without a unit");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::JointProperty& one : srdf.properties) check_property(one, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and ignores the property",
     "moveit2 robot_model.cpp constructJointModel"},
};

}  // namespace

extern constinit const Rule sml3518_srdf_joint_property{
    .id = "SML3518",
    .name = "srdf-joint-property",
    .severity = Severity::warning,
    .summary = "A joint property of an SRDF has an unknown name or value.",
    .remedy =
        "Write motion_model with holonomic or diff_drive, or angular_distance_weight with a number.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3518_srdf_joint_property_file
