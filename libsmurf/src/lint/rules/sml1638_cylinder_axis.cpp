// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1638_cylinder_axis_file {
namespace {

/// The ratio of two lengths, at least 1.
double ratio(double a, double b) { return a > b ? a / b : b / a; }
bool is_alike(double a, double b) {
  constexpr double kTolerance = 1.1;
  return ratio(a, b) < kTolerance;
}

/// The axis, other than z, along which a cylinder of this size would fill the box; -1 when none.
int better_axis(const Vector3& size, double diameter, double length) {
  constexpr double kRound = 1.3;  // below, nobody sees the axis
  if (ratio(diameter, length) < kRound || is_alike(size[2], length)) return -1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool fits = is_alike(size[axis], length) && is_alike(size[1 - axis], diameter) &&
                      is_alike(size[2], diameter);
    if (fits) return static_cast<int>(axis);
  }
  return -1;
}

bool has_same_frame(const urdf::Origin& a, const urdf::Origin& b) {
  const double angle = angle_between(to_pose(a).orientation, to_pose(b).orientation);
  return angle < 0.01;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.visuals.size() != 1 || link.collisions.size() != 1) return;
    const urdf::Visual& visual = link.visuals.front();
    const urdf::Collision& collision = link.collisions.front();
    const auto* cylinder = std::get_if<urdf::Cylinder>(&collision.geometry.shape);
    if (cylinder == nullptr || !cylinder->radius || !cylinder->length) return;
    if (!std::holds_alternative<urdf::Mesh>(visual.geometry.shape)) return;
    const std::optional<Box> box = bounding_box(model, visual.geometry);
    if (!box || !has_same_frame(visual.origin, collision.origin)) return;
    const int axis = better_axis(box->size(), 2 * *cylinder->radius, *cylinder->length);
    if (axis < 0) return;
    Diagnostic& diagnostic = findings.report(
        tag_name(model, collision.geometry.shape_element),
        "the axis of the cylinder is z, but the mesh that it replaces extends along " +
            std::string(axis == 0 ? "x" : "y"));
    diagnostic.label(tag_name(model, visual.geometry.shape_element), "the mesh");
    diagnostic.help(axis == 0 ? "turn its origin by rpy=\"0 1.5708 0\""
                              : "turn its origin by rpy=\"1.5708 0 0\"");
  });
}

}  // namespace

extern constinit const Rule sml1638_cylinder_axis{
    .id = "SML1638",
    .name = "cylinder-axis",
    .severity = Severity::warning,
    .summary = "A collision cylinder is rotated relative to the visual mesh that it replaces.",
    .why = "The axis of a cylinder is z in every reader. Without the rotation of the mesh, the "
           "cylinder is at a right angle to the part that it should cover.",
    .remedy = "Turn the origin of the collision.",
    .sources = "URDF specification; all readers agree.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1638_cylinder_axis_file
