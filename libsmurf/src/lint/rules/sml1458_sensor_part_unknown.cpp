// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/edits.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"
#include "lint/sdf_checks.hpp"
#include "readers/sdf_language.hpp"

namespace smurf::rules::sml1458_sensor_part_unknown_file {
namespace {

/// Parts of a sensor for sensors of some types only.
constexpr struct {
  std::string_view part;
  std::string_view types;  ///< each followed by a blank
} kOwnParts[] = {
    {"air_pressure", "air_pressure "},
    {"altimeter", "altimeter "},
    {"contact", "contact "},
    {"force_torque", "force_torque "},
    {"gps", "gps navsat "},
    {"imu", "imu "},
    {"lidar", "ray gpu_ray lidar gpu_lidar "},
    {"logical_camera", "logical_camera "},
    {"magnetometer", "magnetometer "},
    {"navsat", "gps navsat "},
    {"ray", "ray gpu_ray lidar gpu_lidar "},
    {"sonar", "sonar "},
};

std::vector<std::string_view> names_of(const sdf::Element& row) {
  std::vector<std::string_view> names;
  std::size_t at = 0;
  while (const auto part = sdf::next_part(row.children, at)) names.push_back(part->name);
  return names;
}

/// Elements outside of SDF that sdformat copies and gz-sensors reads: SML3902 judges them.
bool is_of_release(std::string_view name) {
  return is_one_of(name, {"gz_frame_id", "ignition_frame_id", "frame_id", "optical_frame_id"});
}

/// Whether the names of all parts are known, also of those that cannot be wrong.
bool is_complete(std::string_view kind) { return kind != "plugin" && kind != "pose"; }

class Check {
 public:
  explicit Check(Findings& findings) : findings_(findings) {}

  void sensor(xml::View sensor) {
    sensor_ = sensor;
    const std::string type = std::string(sdf::value_of(sensor, "type")) + " ";
    for (const xml::View child : sensor) {
      for (const auto& [part, types] : kOwnParts) {
        const bool is_own = (" " + std::string(types)).find(" " + type) != std::string::npos;
        if (child.name() != part || is_own || type == " ") continue;
        findings_
            .report(child.name_span(), "a sensor of type " + quoted(sdf::value_of(sensor, "type")) +
                                           " has no " + quoted(part))
            .help("delete it, or correct the type");
      }
    }
    plugin_parts(sensor, type);
    children(sensor, *sdf::find("sensor"));
  }

 private:
  /// The part that describes such a sensor, in a plugin: the sensor itself then has the defaults.
  void plugin_parts(xml::View sensor, const std::string& type) {
    for (const auto& [part, types] : kOwnParts) {
      const bool is_own = (" " + std::string(types)).find(" " + type) != std::string::npos;
      if (!is_own || type == " " || sensor.child(part)) continue;
      for (const xml::View child : sensor) {
        const xml::View inner = child.name() == "plugin" ? child.child(part) : xml::View{};
        if (!inner || inner.begin() == inner.end()) continue;
        findings_
            .report(inner.name_span(),
                    "the sensor does not read " + quoted(part) + " in a `plugin`")
            .help("move it from the `plugin` into the `sensor`");
        return;
      }
    }
  }

  // The recursion is as deep as the file, whose depth is limited.
  void children(xml::View parent, const sdf::Element& row) {
    for (const xml::View child : parent) {
      if (child.name().find(':') != std::string_view::npos) continue;  // somebody's own
      if (is_of_release(child.name())) continue;
      const auto part = sdf::find_part(row.children, child.name());
      if (!part) {
        report(child, parent, row);
      } else if (!part->kind.empty() && is_complete(part->kind)) {
        children(child, *sdf::find(part->kind));
      }
    }
  }

  void report(xml::View child, xml::View parent, const sdf::Element& row) {
    Diagnostic& diagnostic = findings_.report(
        child.name_span(), quoted(parent.name()) + " has no " + quoted(child.name()));
    if (const std::string home = home_of(child.name(), sensor_, *sdf::find("sensor"));
        !home.empty()) {
      diagnostic.help("move it into " + quoted(home));
    } else if (const auto meant = nearest(child.name(), names_of(row))) {
      diagnostic.help("did you mean " + quoted(*meant) + "?");
    } else {
      diagnostic.help("delete it, or write it in the `plugin` that reads it");
    }
  }

  /// Where in this sensor a part belongs: "ray/scan"; "" if nowhere.
  static std::string home_of(std::string_view name, xml::View element, const sdf::Element& row) {
    for (const xml::View child : element) {
      const auto part = sdf::find_part(row.children, child.name());
      if (!part || part->kind.empty() || !is_complete(part->kind)) continue;
      const sdf::Element& inner = *sdf::find(part->kind);
      if (sdf::find_part(inner.children, name)) return std::string(child.name());
      const std::string below = home_of(name, child, inner);
      if (!below.empty()) return std::string(child.name()) + "/" + below;
    }
    return {};
  }

  Findings& findings_;
  xml::View sensor_;
};

/// Every sensor in an element, but not what plugins read.
void check_sensors(xml::View element, Check& check) {
  for (const xml::View child : element) {
    if (child.name() == "plugin") continue;
    if (child.name() == "sensor") {
      check.sensor(child);
    } else {
      check_sensors(child, check);
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  Check check(findings);
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() == "gazebo") check_sensors(gazebo, check);
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes, "ignores the element, and uses its default", kRun},
};

}  // namespace

extern constinit const Rule sml1458_sensor_part_unknown{
    .id = "SML1458",
    .name = "sensor-part-unknown",
    .severity = Severity::warning,
    .summary = "A sensor for Gazebo contains an element that SDF does not have there.",
    .why = "A lidar whose `noise` stands beside `ray` has no noise.",
    .remedy = "Correct the name, or move the element to where SDF has it.",
    .sources = "SDF 1.7 to 1.12, sensor.sdf; gazebo_ros_pkgs issue 1187.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml1458_sensor_part_unknown_file
