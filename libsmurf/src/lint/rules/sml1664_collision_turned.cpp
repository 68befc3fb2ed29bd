// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "lint/geometry_queries.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1664_collision_turned_file {
namespace {

constexpr double kSameSize = 0.02;   // of the diagonal
constexpr double kTurned = 0.1;      // of the diagonal; how far an edge of the box moves
constexpr double kTurnedMesh = 0.1;  // rad
constexpr double kBeside = 1;        // of the diagonal; another part then
constexpr double kShared = 0.25;     // of the volume of a box; one beside the other, below

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

/// How much of a box is in another one, 0 to 1.
double shared_part(const Box& a, const Box& b) {
  double part = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double both = std::min(a.high[i], b.high[i]) - std::max(a.low[i], b.low[i]);
    const double size = a.high[i] - a.low[i];
    if (size > 0) part *= std::clamp(both / size, 0.0, 1.0);
  }
  return part;
}

enum class Misfit : std::uint8_t { none, turned, beside };

/// Whether the collision has the shape and size of the visual, but is turned, or is beside it.
Misfit misfit_of(const LinkedModel& model, const urdf::Visual& visual,
                 const urdf::Collision& collision) {
  if (is_in_degrees(visual.origin) || is_in_degrees(collision.origin))
    return Misfit::none;  // SML1441
  if (visual.geometry.shape.index() != collision.geometry.shape.index()) return Misfit::none;
  const std::optional<Box> seen = bounding_box(model, visual.geometry);
  const std::optional<Box> felt = bounding_box(model, collision.geometry);
  if (!seen || !felt) return Misfit::none;
  const double diagonal = diagonal_of(*seen);
  if (!(diagonal > 0) || !are_near(seen->size(), felt->size(), kSameSize * diagonal))
    return Misfit::none;
  const Pose X_VC = inverse(urdf::to_pose(visual.origin)) * urdf::to_pose(collision.origin);
  const Box turned = moved(*felt, X_VC);
  if (!are_near(turned.center(), seen->center(), kBeside * diagonal)) return Misfit::none;
  const bool is_mesh = std::holds_alternative<urdf::Mesh>(visual.geometry.shape);
  if (is_mesh && !is_same_mesh(visual.geometry, collision.geometry)) return Misfit::none;
  const bool is_sphere = std::holds_alternative<urdf::Sphere>(visual.geometry.shape);
  const bool is_turned =
      is_mesh ? angle_between(X_VC.orientation, {}) > kTurnedMesh
              : !is_sphere && !are_near(turned.size(), seen->size(), kTurned * diagonal);
  if (is_turned) return Misfit::turned;
  return shared_part(*seen, turned) < kShared ? Misfit::beside : Misfit::none;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.visuals.size() != 1 || link.collisions.size() != 1) return;
    const urdf::Collision& collision = link.collisions.front();
    const Misfit misfit = misfit_of(model, link.visuals.front(), collision);
    if (misfit == Misfit::none) return;
    const bool is_turned = misfit == Misfit::turned;
    const Field<Vector3>& given = is_turned ? collision.origin.rpy : collision.origin.xyz;
    findings
        .report_habit(given ? given.span : tag_name(model, collision.element),
                      "the collision of " + title(link) +
                          " has the shape and size of its visual, but " +
                          (is_turned ? "is turned" : "is beside it"),
                      "such collisions", static_cast<std::size_t>(misfit))
        .help("write the `origin` of the visual into the collision, too");
  });
}

}  // namespace

extern constinit const Rule sml1664_collision_turned{
    .id = "SML1664",
    .name = "collision-turned",
    .severity = Severity::warning,
    .summary =
        "A collision has the shape and size of its visual, but another orientation or place.",
    .why =
        "A cylinder of URDF stands upright: a wheel whose collision is not turned like its visual "
        "touches the ground with its rim's edge, and sinks in or hops.",
    .remedy = "Write the origin of the visual into the collision.",
    .sources = "mir_robot issue 25. Links with one visual and one collision.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1664_collision_turned_file
