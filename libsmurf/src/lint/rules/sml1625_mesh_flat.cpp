// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/numbers/vectors.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/mesh_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1625_mesh_flat_file {
namespace {

constexpr Circumstance kFewCorners{"fewer than four corners"};

/// A mesh of which every corner is known.
bool is_small(const MeshFacts& facts) {
  constexpr std::uint64_t kMost = 100;
  return facts.triangles <= kMost;
}

/// The farthest of the points in some measure.
template <class Measure>
std::size_t farthest(const std::vector<std::array<float, 3>>& points, const Measure& measure) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (measure(points[i]) > measure(points[best])) best = i;
  }
  return best;
}

Vector3 between(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {double{b[0]} - double{a[0]}, double{b[1]} - double{a[1]}, double{b[2]} - double{a[2]}};
}

/// Whether all points lie in a plane, apart from rounding.
bool are_coplanar(const std::vector<std::array<float, 3>>& points) {
  constexpr double kRounding = 1e-7;  // of the size
  if (points.size() < 4) return true;
  const std::array<float, 3>& first = points.front();
  const auto length = [](const Vector3& v) { return std::sqrt(dot(v, v)); };
  const auto along = [&](const auto& point) { return length(between(first, point)); };
  const Vector3 edge = between(first, points[farthest(points, along)]);
  const auto across = [&](const auto& point) { return length(cross(edge, between(first, point))); };
  const Vector3 normal = cross(edge, between(first, points[farthest(points, across)]));
  const double size = length(edge);
  const double scale = length(normal);
  if (!(scale > kRounding * size * size)) return true;  // in a line
  const auto above = [&](const auto& point) {
    return std::fabs(dot(normal, between(first, point))) / scale;
  };
  return above(points[farthest(points, above)]) <= kRounding * size;
}

bool is_flat(const MeshFacts& facts) {
  if (facts.defect || facts.triangles == 0 || !facts.box) return false;
  const Vector3 size = facts.box->size();
  const bool is_along_axes =
      std::any_of(size.begin(), size.end(), [](double extent) { return extent == 0; });
  return is_along_axes || (is_small(facts) && !facts.outer.empty() && are_coplanar(facts.outer));
}

std::size_t corners_of(const MeshFacts& facts) {
  return std::set<std::array<float, 3>>(facts.outer.begin(), facts.outer.end()).size();
}

void check(const LinkedModel& model, Findings& findings) {
  const bool has_visuals = keeps_visuals(model);
  constexpr std::size_t kOfBody = 4;
  const auto is_used = [&](const OpenedMesh& mesh) {
    return (mesh.is_collision() || has_visuals) && is_flat(mesh.facts);
  };
  Diagnostic* flat = report_meshes(
      model,
      [&](const OpenedMesh& mesh) {
        return is_used(mesh) && (!is_small(mesh.facts) || corners_of(mesh.facts) >= kOfBody);
      },
      "the collision mesh is flat: its volume is zero",
      "of collisions are flat: their volume is zero", findings);
  if (flat != nullptr && has_visuals) {
    flat->note("`discardvisual=\"false\"` makes MuJoCo read visuals, too");
  }
  const auto has_few = [](const OpenedMesh& mesh) {
    return is_flat(mesh.facts) && is_small(mesh.facts) && corners_of(mesh.facts) < kOfBody;
  };
  Diagnostic* few = report_meshes(
      model, [&](const OpenedMesh& mesh) { return is_used(mesh) && has_few(mesh); },
      "the mesh has fewer than four corners", "have fewer than four corners", findings);
  if (few != nullptr) few->when(kFewCorners);
  few = report_meshes(
      model, [&](const OpenedMesh& mesh) { return !is_used(mesh) && has_few(mesh); },
      "the mesh has fewer than four corners", "have fewer than four corners", findings);
  if (few == nullptr) return;
  few->severity = Severity::info;
  few->when(kFewCorners);
}

constexpr Fact kFacts[] = {
    {&readers::isaac, Effect::loses, "leaves the shape out", kRun, when(kFewCorners)},
    {&readers::mujoco, Effect::refuses, "needs at least four corners, and refuses the model", kRun,
     when(kFewCorners)},
    {&readers::mujoco, Effect::refuses, "can make no convex hull of it, and refuses the model",
     kRun},
    {&readers::urdf, Effect::takes, "loads it", "Bullet, DART, Newton and Pinocchio, run"},
};

}  // namespace

extern constinit const Rule sml1625_mesh_flat{.id = "SML1625",
                                              .name = "mesh-flat",
                                              .severity = Severity::error,
                                              .summary = "The collision mesh lies in a plane.",
                                              .remedy =
                                                  "Give the mesh a thickness, or use a thin box.",
                                              .check_model = check,
                                              .facts = kFacts,
                                              .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1625_mesh_flat_file
