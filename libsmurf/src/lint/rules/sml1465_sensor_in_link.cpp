// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/sdf_sensor_types.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1465_sensor_in_link_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const xml::View child : xml::View(model.robot->document, link.element)) {
      if (child.name() != "sensor") continue;
      // The `sensor` that URDF once had holds a `camera` or `ray`, and no type.
      const xml::Attribute* type = child.attribute("type");
      if (type == nullptr || !ranges::contains(kSdfSensorTypes, type->value())) continue;
      findings
          .report(child.name_span(), "a `sensor` of a URDF stands in `<gazebo reference=\"" +
                                         std::string(link.name.value_or("LINK")) +
                                         "\">`, and not in the link")
          .help("move it into such an element of `robot`");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "drops the sensor", kRun},
    {&readers::urdf, Effect::ignores, "does not read it", "urdfdom link.cpp parseLink"},
};

}  // namespace

extern constinit const Rule sml1465_sensor_in_link{
    .id = "SML1465",
    .name = "sensor-in-link",
    .severity = Severity::warning,
    .summary = "A sensor for Gazebo stands in a link of the URDF.",
    .why = "The simulation lacks the sensor.",
    .remedy = "Write it in `<gazebo reference=\"LINK\">`.",
    .sources = "gazebo_ros_pkgs issue 1181.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1465_sensor_in_link_file
