// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <variant>

#include "lint/geometry_queries.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1664_collision_turned_file {
namespace {

constexpr double kSameSize = 0.02;   // of the diagonal
constexpr double kTurned = 0.1;      // of the diagonal; how far an edge of the box moves
constexpr double kTurnedMesh = 0.1;  // rad
constexpr double kBeside = 1;        // of the diagonal; another part then

bool are_near(const Vector3& a, const Vector3& b, double tolerance) {
  return std::fabs(a[0] - b[0]) <= tolerance && std::fabs(a[1] - b[1]) <= tolerance &&
         std::fabs(a[2] - b[2]) <= tolerance;
}

bool is_same_mesh(const urdf::Geometry& a, const urdf::Geometry& b) {
  const auto* one = std::get_if<urdf::Mesh>(&a.shape);
  const auto* other = std::get_if<urdf::Mesh>(&b.shape);
  return one != nullptr && other != nullptr &&
         one->filename.value_or("") == other->filename.value_or("") &&
         one->scale.value_or({1, 1, 1}) == other->scale.value_or({1, 1, 1});
}

bool is_in_degrees(const urdf::Origin& origin) {
  constexpr double kFullTurn = 6.3;  // rad
  const Vector3 rpy = origin.rpy.value_or({});
  return std::any_of(rpy.begin(), rpy.end(),
                     [](double angle) { return std::fabs(angle) > kFullTurn; });
}

/// Whether the collision has the shape and size of the visual, but is turned.
bool is_turned(const LinkedModel& model, const urdf::Visual& visual,
               const urdf::Collision& collision) {
  if (is_in_degrees(visual.origin) || is_in_degrees(collision.origin)) return false;  // SML1441
  if (visual.geometry.shape.index() != collision.geometry.shape.index()) return false;
  const std::optional<Box> seen = bounding_box(model, visual.geometry);
  const std::optional<Box> felt = bounding_box(model, collision.geometry);
  if (!seen || !felt) return false;
  const double diagonal = diagonal_of(*seen);
  if (!(diagonal > 0) || !are_near(seen->size(), felt->size(), kSameSize * diagonal)) return false;
  const Pose X_VC = inverse(urdf::to_pose(visual.origin)) * urdf::to_pose(collision.origin);
  const Box turned = moved(*felt, X_VC);
  if (!are_near(turned.center(), seen->center(), kBeside * diagonal)) return false;
  if (std::holds_alternative<urdf::Mesh>(visual.geometry.shape)) {
    return is_same_mesh(visual.geometry, collision.geometry) &&
           angle_between(X_VC.orientation, {}) > kTurnedMesh;
  }
  if (std::holds_alternative<urdf::Sphere>(visual.geometry.shape)) return false;
  return !are_near(turned.size(), seen->size(), kTurned * diagonal);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.visuals.size() != 1 || link.collisions.size() != 1) return;
    const urdf::Collision& collision = link.collisions.front();
    if (!is_turned(model, link.visuals.front(), collision)) return;
    const Field<Vector3>& rpy = collision.origin.rpy;
    findings
        .report_habit(rpy ? rpy.span : tag_name(model, collision.element),
                      "the collision of " + title(link) +
                          " has the shape and size of its visual, but is turned",
                      "such collisions")
        .help("write the `origin` of the visual into the collision, too");
  });
}

}  // namespace

extern constinit const Rule sml1664_collision_turned{
    .id = "SML1664",
    .name = "collision-turned",
    .severity = Severity::warning,
    .summary = "A collision has the shape and size of its visual, but another orientation.",
    .why =
        "A cylinder of URDF stands upright: a wheel whose collision is not turned like its visual "
        "touches the ground with its rim's edge, and sinks in or hops.",
    .remedy = "Write the origin of the visual into the collision.",
    .sources = "mir_robot issue 25. Links with one visual and one collision.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1664_collision_turned_file
