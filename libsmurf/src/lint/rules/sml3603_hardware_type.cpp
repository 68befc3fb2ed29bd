// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <map>

#include "base/text/suggest.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3603_hardware_type_file {
namespace {

constexpr Circumstance kTwice{"twice"};

constexpr std::array<std::string_view, 3> kTypes = {"system", "sensor", "actuator"};

void check_type(const Hardware& one, Findings& findings) {
  const xml::Attribute* type = one.element.attribute("type");
  if (type == nullptr || std::find(kTypes.begin(), kTypes.end(), one.type) != kTypes.end()) return;
  Diagnostic& found = findings.report(place_of(one.element, "type"),
                                      title_of(one) + " has the type " + quoted(one.type));
  const auto near = only_nearest(one.type, kTypes);
  found.help(near ? "did you mean " + quoted(*near) + "?" : "write system, sensor or actuator");
  if (near && !type->value_span().empty()) {
    found.fixes.push_back({Applicability::unsafe, {{type->value_span(), std::string(*near)}}});
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  std::map<std::string_view, Span> known;
  for (const Hardware& one : hardware_of(model)) {
    check_type(one, findings);
    if (one.name.empty()) continue;
    const Span place = place_of(one.element, "name");
    const auto [first, is_new] = known.emplace(one.name, place);
    if (is_new) continue;
    findings.report(place, "there is a ros2_control " + quoted(one.name) + " already")
        .label(first->second, "the first one is here")
        .help("rename one of them")
        .when(kTwice);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::refuses, "reports an error and loads no hardware after it",
     "ros2_control hardware_interface/src/resource_manager.cpp", when(kTwice)},
    {&readers::ros2_control, Effect::refuses,
     "makes no component for it, misses its interfaces and clears all hardware",
     "ros2_control hardware_interface/src/resource_manager.cpp validate_storage"},
    no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3603_hardware_type{
    .id = "SML3603",
    .name = "hardware-type",
    .severity = Severity::error,
    .summary = "A `ros2_control` has an unknown type, or the name of another one.",
    .remedy = "Write system, sensor or actuator as type, and give each one its own name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3603_hardware_type_file
