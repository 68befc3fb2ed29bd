// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/measured_frames.hpp"

#include <algorithm>

#include "mjcf/reading.hpp"

namespace smurf::mjcf {
namespace {

/// The frame of the inertia, which "body" names. MuJoCo turns that of several shapes, and of a full
/// tensor, to axes of its own choice; then only the position is known here.
std::optional<MeasuredFrame> of_inertia(const Body& body, std::uint32_t index, Reporter& reporter) {
  if (!body.mass) return std::nullopt;
  const Pose at_center{body.mass->center, {}};
  const bool is_aligned = std::any_of(body.joints.begin(), body.joints.end(),
                                      [](const Joint& one) { return one.is_aligned; });
  if (is_aligned) return MeasuredFrame{index, at_center, false};
  const bool is_written =
      body.inertial && body.file->compiler().inertiafromgeom != InertiaFromGeom::yes;
  if (is_written) {
    const Pose written = pose_of(Settings(body.inertial, nullptr), body.file->compiler(), reporter);
    const bool is_turned = body.inertial.attribute("fullinertia") != nullptr;
    return MeasuredFrame{index, {at_center.position, written.orientation}, !is_turned};
  }
  const Geom* single = nullptr;
  const auto& groups = body.file->compiler().inertiagrouprange;
  for (const Geom& one : body.geoms) {
    const bool counts =
        one.group >= groups[0] && one.group <= groups[1] && one.mass && one.mass->mass > 0;
    if (!counts) continue;
    if (single != nullptr || !one.mesh.empty()) return MeasuredFrame{index, at_center, false};
    single = &one;
  }
  const Quaternion axes = single != nullptr ? single->pose.orientation : Quaternion{};
  return MeasuredFrame{index, {at_center.position, axes}, single != nullptr};
}

}  // namespace

std::optional<MeasuredFrame> measured_frame(const Model& model, const PartsByName& parts,
                                            const Reference& sensor, std::string_view which,
                                            Reporter& reporter) {
  const Attribute* kind = sensor.element.attribute(std::string(which) + "type");
  const Attribute* name = sensor.element.attribute(std::string(which) + "name");
  if (kind == nullptr || name == nullptr) return std::nullopt;
  if (kind->value() == "site") {
    const Site* site = parts.site(name, sensor.around);
    if (site == nullptr) return std::nullopt;
    return MeasuredFrame{site->body, site->pose, true};
  }
  const std::string full = full_name(name->value(), sensor.around);
  if (kind->value() == "camera") {
    for (const Camera& one : model.cameras) {
      const std::string_view mode = one.settings.text("mode");
      if (one.name == full && (mode.empty() || mode == "fixed"))
        return MeasuredFrame{one.body, one.pose, true};
    }
    return std::nullopt;
  }
  if (kind->value() == "geom") {
    for (std::uint32_t i = 0; i < model.bodies.size(); ++i) {
      for (const Geom& one : model.bodies[i].geoms) {
        // The frame of a mesh is that of its inertia, whose axes MuJoCo chooses.
        if (one.name == full && one.mesh.empty()) return MeasuredFrame{i, one.pose, true};
      }
    }
    return std::nullopt;
  }
  const auto index = parts.body(name, sensor.around);
  if (!index) return std::nullopt;
  if (kind->value() == "xbody") return MeasuredFrame{*index, {}, true};
  return of_inertia(model.bodies[*index], *index, reporter);
}

}  // namespace smurf::mjcf
