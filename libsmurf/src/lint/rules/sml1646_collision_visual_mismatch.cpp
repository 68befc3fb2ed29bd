// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "link/shape_solids.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1646_collision_visual_mismatch_file {
namespace {

/// The box around all shapes of a link, in the link's frame; none if a size is unknown.
class LinkBox {
 public:
  LinkBox(const LinkedModel& model) : model_(model) {}

  void add(const urdf::Origin& origin, const urdf::Geometry& geometry) {
    const std::optional<Box> shape = bounding_box(model_, geometry);
    const bool is_readable =
        (origin.xyz || !origin.xyz.written) && (origin.rpy || !origin.rpy.written);
    if (!shape || !is_readable) {
      is_known_ = false;
      return;
    }
    const Box in_link = moved(*shape, urdf::to_pose(origin));
    box_ = box_ ? united(*box_, in_link) : in_link;
  }

  std::optional<Box> box() const { return is_known_ ? box_ : std::nullopt; }

 private:
  const LinkedModel& model_;
  std::optional<Box> box_;
  bool is_known_ = true;
};

double diagonal(const Box& box) {
  const Vector3 size = box.size();
  return hypotenuse(size[0], size[1], size[2]);
}

/// Distance between the nearest faces of two boxes, 0 when they touch.
double gap(const Box& a, const Box& b) {
  Vector3 distance{};
  for (std::size_t i = 0; i < 3; ++i) {
    distance[i] = std::max({0.0, a.low[i] - b.high[i], b.low[i] - a.high[i]});
  }
  return hypotenuse(distance[0], distance[1], distance[2]);
}

/// The mass and the shapes disagree as well, or the shapes lie far apart: SML1520, or SML1442.
bool is_otherwise_reported(const LinkedModel& model, const urdf::Link& link) {
  const auto extent = extent_of(model, link);
  const double mass = link.inertial ? link.inertial->mass.value_or(0) : 0;
  return extent && mass >= kNegligibleMass && mass < kLightestMaterial * extent->volume();
}

/// Reports a link, or adds it to the finding of another one.
void report(const LinkedModel& model, const urdf::Link& link, std::string message,
            Diagnostic*& first, std::size_t& others, Findings& findings) {
  if (first != nullptr) {
    ++others;
    return;
  }
  first = &findings.report(tag_name(model, link.collisions.front().element), std::move(message));
  first->label(tag_name(model, link.visuals.front().element), "the visual");
}

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* first = nullptr;
  std::size_t others = 0;
  const double larger = findings.tolerance();  // where a mesh may have another unit
  constexpr double kMuchLarger = 500;          // between shapes that are not meshes
  for_each_link(model, [&](const urdf::Link& link) {
    LinkBox visual(model);
    LinkBox collision(model);
    bool has_mesh = false;
    bool has_gltf = false;
    for (const urdf::Visual& one : link.visuals) {
      visual.add(one.origin, one.geometry);
      has_mesh = has_mesh || std::holds_alternative<urdf::Mesh>(one.geometry.shape);
      has_gltf = has_gltf || is_gltf(model, one.geometry);
    }
    for (const urdf::Collision& one : link.collisions) {
      collision.add(one.origin, one.geometry);
      has_mesh = has_mesh || std::holds_alternative<urdf::Mesh>(one.geometry.shape);
      has_gltf = has_gltf || is_gltf(model, one.geometry);
    }
    if (!visual.box() || !collision.box()) return;
    const double seen = diagonal(*visual.box());
    const double felt = diagonal(*collision.box());
    if (!(seen > 0 && felt > 0)) return;
    const double ratio = felt / seen;
    std::string message;
    const double most = has_mesh ? larger : std::max(larger, kMuchLarger);
    if (ratio > most || ratio < 1 / most) {
      message = "the collision of " + title(link) + " measures " + format_rounded(felt, 3) +
                " m across, its visual " + format_rounded(seen, 3) + " m";
    } else if (has_mesh && !has_gltf &&
               gap(*visual.box(), *collision.box()) > std::max(seen, felt)) {
      message = "the collision of " + title(link) + " lies " +
                format_rounded(gap(*visual.box(), *collision.box()), 3) + " m away from its visual";
    } else {
      return;
    }
    if (is_otherwise_reported(model, link)) return;
    report(model, link, std::move(message), first, others, findings);
  });
  if (others > 0) first->note("this applies to " + counted(others, "more link"));
}

}  // namespace

extern constinit const Rule sml1646_collision_visual_mismatch{
    .id = "SML1646",
    .name = "collision-visual-mismatch",
    .severity = Severity::warning,
    .summary = "The collision of a link differs widely from its visual in size or place.",
    .why = "Most likely, one of them has a wrong scale or origin.",
    .remedy = "Compare `scale` and `origin` of both.",
    .sources = "Bounding boxes of shapes and meshes.",
    .check_model = check,
    .tolerance = {.value = 20, .meaning = "the largest ratio of their sizes that is accepted"},
    .about = About::robot};

}  // namespace smurf::rules::sml1646_collision_visual_mismatch_file
