// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1532_inertial_in_mesh_frame_file {
namespace {

double distance_between(const Vector3& a, const Vector3& b) {
  const Vector3 d = difference(a, b);
  return std::sqrt(dot(d, d));
}

std::string shown(const Vector3& point) {
  return format_rounded(point[0], 3) + " " + format_rounded(point[1], 3) + " " +
         format_rounded(point[2], 3);
}

/// A visual or collision of a link.
struct Part {
  const urdf::Origin& origin;
  const urdf::Geometry& geometry;
};

/// Whether the centre of mass is that of the mesh in the frame of the mesh, and not in that of the
/// link.
bool is_in_mesh_frame(const LinkedModel& model, const Vector3& center, const Part& part) {
  constexpr double kEqual = 0.02;  // of the diagonal of the mesh
  constexpr double kFar = 0.15;    // of the diagonal; the centre of a real part is not exact
  if (!std::holds_alternative<urdf::Mesh>(part.geometry.shape)) return false;
  const std::optional<Solid> solid = solid_of(model, part.geometry);
  const std::optional<Box> box = bounding_box(model, part.geometry);
  if (!solid || !box) return false;
  const double diagonal = distance_between(box->low, box->high);
  const Vector3 in_link = moved(*solid, urdf::to_pose(part.origin)).center;
  return distance_between(center, solid->center) < kEqual * diagonal &&
         distance_between(center, in_link) > kFar * diagonal &&
         // A centre at the origin is often a placeholder.
         distance_between(center, {}) > kFar * diagonal;
}

void check_part(const LinkedModel& model, const urdf::Link& link, const Part& part,
                Findings& findings) {
  const urdf::Origin& origin = link.inertial->origin;
  const Vector3 center = urdf::to_pose(origin).position;
  if (!origin.xyz || !is_in_mesh_frame(model, center, part)) return;
  const Vector3 in_link = moved(*solid_of(model, part.geometry), urdf::to_pose(part.origin)).center;
  Diagnostic& diagnostic =
      findings.report(origin.xyz.span, "the centre of mass of " + title(link) +
                                           " is that of its mesh, but in the frame of the mesh");
  const bool is_placed = part.origin.xyz || part.origin.rpy;
  const Span place = part.origin.xyz ? part.origin.xyz.span : part.origin.rpy.span;
  if (is_placed) diagnostic.label(place, "this moves the mesh");
  diagnostic.help("in the frame of the link, it is \"" + shown(in_link) +
                  "\"; turn the inertia in the same way");
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || link.inertial->mass.value_or(0) < kSmallestPart) return;
    // Of several shapes, no single one has the centre of the link.
    if (link.visuals.size() == 1) {
      const urdf::Visual& visual = link.visuals.front();
      check_part(model, link, {visual.origin, visual.geometry}, findings);
    } else if (link.visuals.empty() && link.collisions.size() == 1) {
      const urdf::Collision& collision = link.collisions.front();
      check_part(model, link, {collision.origin, collision.geometry}, findings);
    }
  });
}

}  // namespace

extern constinit const Rule sml1532_inertial_in_mesh_frame{
    .id = "SML1532",
    .name = "inertial-in-mesh-frame",
    .severity = Severity::warning,
    .summary = "The centre of mass of a link is in the frame of its mesh, and not of the link.",
    .why = "CAD and mesh programs print the centre of mass in the frame of the mesh. If the origin "
           "of the visual moves or turns the mesh, the mass is then elsewhere than the part.",
    .remedy = "Move and turn the inertial in the same way as the mesh.",
    .sources = "The centre of the volume of the mesh, before and after the origin of the visual.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1532_inertial_in_mesh_frame_file
