// SPDX-License-Identifier: BSD-3-Clause
#include "lint/body.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "link/inertia.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf {
namespace {

Eigen::Matrix3d rotation_of(const urdf::Origin& origin) {
  const std::array<double, 9> m = to_matrix(urdf::to_pose(origin).orientation);
  Eigen::Matrix3d matrix;
  matrix << m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8];
  return matrix;
}

/// Adds a shape to the box; false if the size of the shape is unknown, or not positive. The unit of
/// a mesh may be wrong; likely_cause() says so.
bool add(const LinkedModel& model, const urdf::Origin& origin, const urdf::Geometry& geometry,
         std::optional<Box>& all) {
  const std::optional<Box> box = bounding_box(model, geometry);
  if (!box) return false;
  const Vector3 size = box->size();
  if (!(size[0] > 0 && size[1] > 0 && size[2] > 0)) return false;
  const double longest = std::max({size[0], size[1], size[2]});
  constexpr double kHuge = 50;     // m
  constexpr double kTiny = 0.001;  // m
  const bool is_mesh = std::holds_alternative<urdf::Mesh>(geometry.shape);
  if (is_mesh && (longest > kHuge || longest < kTiny)) return false;  // SML1630
  const Box in_link = moved(*box, urdf::to_pose(origin));
  all = all ? united(*all, in_link) : in_link;
  return true;
}

}  // namespace

double Extent::volume() const {
  return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
}

double Extent::longest_edge() const {
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

Extent Extent::grown(double margin) const {
  Extent larger = *this;
  for (std::size_t i = 0; i < 3; ++i) {
    larger.low[i] -= margin;
    larger.high[i] += margin;
  }
  return larger;
}

bool Extent::contains(const Vector3& point) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (point[i] < low[i] || point[i] > high[i]) return false;
  }
  return true;
}

std::optional<Extent> extent_of(const LinkedModel& model, const urdf::Link& link) {
  std::optional<Box> all;
  for (const urdf::Visual& visual : link.visuals) {
    if (!add(model, visual.origin, visual.geometry, all)) return std::nullopt;
  }
  for (const urdf::Collision& collision : link.collisions) {
    if (!add(model, collision.origin, collision.geometry, all)) return std::nullopt;
  }
  return all ? std::optional(Extent{all->low, all->high}) : std::nullopt;
}

std::optional<Extent> extent_of_rigid_parts(const LinkedModel& model, const urdf::Link& link) {
  constexpr std::size_t kMostParts = 32;
  struct Part {
    std::size_t link;
    Pose X_LP;
  };
  const std::vector<urdf::Link>& links = model.robot->links;
  std::vector<Part> parts{{static_cast<std::size_t>(&link - links.data()), {}}};
  const auto add_part = [&](std::optional<LinkIndex> other, const Pose& X_LO) {
    if (!other || parts.size() >= kMostParts) return;
    const std::size_t index = to_size(*other);
    const bool is_known =
        std::any_of(parts.begin(), parts.end(), [&](const Part& one) { return one.link == index; });
    const auto& inertial = links[index].inertial;
    const bool has_mass = inertial && inertial->mass.value_or(0) > 0;
    if (!is_known && !has_mass) parts.push_back({index, X_LO});
  };
  std::optional<Box> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part part = parts[i];
    const urdf::Link& own = links[part.link];
    if (!own.visuals.empty() || !own.collisions.empty()) {
      const auto extent = extent_of(model, own);
      if (!extent) return std::nullopt;
      const Box box = moved(Box{extent->low, extent->high}, part.X_LP);
      all = all ? united(*all, box) : box;
    }
    for (const JointIndex below : model.tree.child_joints[part.link]) {
      const urdf::Joint& joint = model.joint(below);
      if (joint.type != urdf::JointType::fixed) continue;
      add_part(model.tree.joint_child[to_size(below)], part.X_LP * urdf::to_pose(joint.origin));
    }
    const auto above = model.tree.parent_joint[part.link];
    if (!above || model.joint(*above).type != urdf::JointType::fixed) continue;
    add_part(model.tree.joint_parent[to_size(*above)],
             part.X_LP * inverse(urdf::to_pose(model.joint(*above).origin)));
  }
  return all ? std::optional(Extent{all->low, all->high}) : std::nullopt;
}

std::optional<Body> body_of(const urdf::Inertial& inertial) {
  const auto moments = principal_moments(inertial);
  if (!moments || !inertial.mass || !(*inertial.mass > 0)) return std::nullopt;
  if (!is_positive_definite(*moments) || triangle_excess(*moments) > kImpossibleExcess) {
    return std::nullopt;
  }
  Eigen::Matrix3d tensor;
  tensor << *inertial.ixx, *inertial.ixy, *inertial.ixz,  //
      *inertial.ixy, *inertial.iyy, *inertial.iyz,        //
      *inertial.ixz, *inertial.iyz, *inertial.izz;
  const Eigen::Matrix3d rotation = rotation_of(inertial.origin);
  const Eigen::Vector3d in_link = (rotation * tensor * rotation.transpose()).diagonal();
  const double half_trace = in_link.sum() / 2;
  return Body{*inertial.mass,
              urdf::to_pose(inertial.origin).position,
              {half_trace - in_link[0], half_trace - in_link[1], half_trace - in_link[2]}};
}

double excess_over(const Body& body, const Extent& extent) {
  const bool is_inside = extent.contains(body.center);
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = (extent.high[i] - extent.low[i]) / 2;
    // The middle allows the largest inertia.
    const double square = is_inside
                              ? (extent.high[i] - body.center[i]) * (body.center[i] - extent.low[i])
                              : half * half;
    worst = std::max(worst, body.second_moments[i] / (body.mass * square));
  }
  return worst;
}

double ratio_to_block(const Body& body, const Extent& extent) {
  double of_block = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    of_block += std::pow(extent.high[i] - extent.low[i], 2) * body.mass / 12;
  }
  return (body.second_moments[0] + body.second_moments[1] + body.second_moments[2]) / of_block;
}

}  // namespace smurf
