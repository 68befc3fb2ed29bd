// SPDX-License-Identifier: BSD-3-Clause
#include "link/link_overlaps.hpp"

#include <algorithm>
#include <map>

#include "base/deadline.hpp"
#include "link/shape_boxes.hpp"

namespace smurf {
namespace {

/// Robots have fewer; the work grows with the pairs.
constexpr std::size_t kMostShapes = 2000;
constexpr std::size_t kMostPairs = 5000;
constexpr double kLeast = 0.0005;  // m: less is rounding

double thickness_of(const Box& box) {
  const Vector3 size = box.size();
  return std::min({size[0], size[1], size[2]});
}

/// Whether a ball of this diameter fits into the intersection of two boxes.
bool have_room(const Box& a, const Box& b, double diameter) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::min(a.high[i], b.high[i]) - std::max(a.low[i], b.low[i]) < diameter) return false;
  }
  return true;
}

}  // namespace

std::vector<std::size_t> bodies_of(const LinkedModel& model) {
  std::vector<std::size_t> body(model.robot->links.size());
  for (std::size_t i = 0; i < body.size(); ++i) body[i] = i;
  for (const LinkIndex link : model.tree.order) {
    const auto joint = model.tree.parent_joint[to_size(link)];
    if (!joint || model.joint(*joint).type != urdf::JointType::fixed) continue;
    body[to_size(link)] = body[to_size(*model.tree.joint_parent[to_size(*joint)])];
  }
  return body;
}

bool are_apart(const LinkedModel& model, const std::vector<std::size_t>& bodies, std::size_t link,
               std::size_t other) {
  const auto carrier_of = [&](std::size_t body) {
    const auto joint = model.tree.parent_joint[body];
    return joint ? bodies[to_size(*model.tree.joint_parent[to_size(*joint)])] : body;
  };
  const std::size_t a = bodies[link];
  const std::size_t b = bodies[other];
  return a != b && carrier_of(a) != b && carrier_of(b) != a;
}

JointPositions rest_positions(const LinkedModel& model) {
  JointPositions positions;
  for (const urdf::Joint& joint : model.robot->joints) {
    const bool is_bounded =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!joint.name || !is_bounded || !joint.limit) continue;
    const double lower = joint.limit->lower.value_or(0);
    const double upper = joint.limit->upper.value_or(0);
    if (lower > 0 && lower <= upper) positions[*joint.name] = lower;
    if (upper < 0 && lower <= upper) positions[*joint.name] = upper;
  }
  return positions;
}

/// A shape in the frame of the root.
struct LinkOverlaps::Placed {
  Shape* shape;
  Pose X_RC;
  Box box;
  std::optional<ConvexHull> hull = std::nullopt;

  /// Whether the boxes of two shapes, which contain their hulls, have room along the axes of both.
  bool is_near(const Placed& other, double least) const {
    return have_room(shape->own, moved(other.shape->own, inverse(X_RC) * other.X_RC), least) &&
           have_room(other.shape->own, moved(shape->own, inverse(other.X_RC) * X_RC), least);
  }
};

LinkOverlaps::LinkOverlaps(const LinkedModel& model) : model_(model), bodies_(bodies_of(model)) {
  std::size_t count = 0;
  for (const urdf::Link& link : model.robot->links) count += link.collisions.size();
  if (count < 2 || count > kMostShapes) return;
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    for (const urdf::Collision& collision : model.robot->links[i].collisions) {
      const std::optional<Box> box = box_of(model, collision.geometry);
      if (box) shapes_.push_back({&collision, i, urdf::to_pose(collision.origin), *box});
    }
  }
}

const ConvexHull* LinkOverlaps::hull_of(Shape& shape) const {
  if (!shape.has_tried) shape.hull = smurf::hull_of(model_, shape.collision->geometry);
  shape.has_tried = true;
  return shape.hull ? &*shape.hull : nullptr;
}

std::vector<LinkOverlap> LinkOverlaps::find(const JointPositions& positions, double most,
                                            double part) {
  const auto poses = forward_kinematics(model_, positions);
  std::vector<Placed> all;
  for (Shape& shape : shapes_) {
    if (!poses[shape.link]) continue;
    const Pose X_RC = *poses[shape.link] * shape.X_LC;
    all.push_back({&shape, X_RC, moved(shape.own, X_RC)});
  }
  std::sort(all.begin(), all.end(),
            [](const Placed& a, const Placed& b) { return a.box.low[0] < b.box.low[0]; });
  const auto hull_in_root = [&](Placed& placed) -> const ConvexHull* {
    if (!placed.hull) {
      const ConvexHull* own = hull_of(*placed.shape);
      if (own != nullptr) placed.hull = moved(*own, placed.X_RC);
    }
    return placed.hull ? &*placed.hull : nullptr;
  };
  std::map<std::pair<std::size_t, std::size_t>, LinkOverlap> deepest;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size() && all[k].box.low[0] <= all[i].box.high[0]; ++k) {
      Deadline::look(1);
      if (!are_apart(model_, bodies_, all[i].shape->link, all[k].shape->link)) continue;
      const double thickness =
          std::min(thickness_of(all[i].shape->own), thickness_of(all[k].shape->own));
      const double least = part > 0 ? std::min(most, std::max(kLeast, part * thickness)) : most;
      if (!have_room(all[i].box, all[k].box, least)) continue;
      if (++pairs > kMostPairs) return {};
      if (!all[i].is_near(all[k], least)) continue;
      const ConvexHull* one = hull_in_root(all[i]);
      const ConvexHull* other = one != nullptr ? hull_in_root(all[k]) : nullptr;
      const double depth = other != nullptr ? overlap_of(*one, *other, least) : 0;
      if (depth == 0) continue;
      const bool is_swapped = all[i].shape->link > all[k].shape->link;
      const Shape& first = *all[is_swapped ? k : i].shape;
      const Shape& second = *all[is_swapped ? i : k].shape;
      const LinkOverlap overlap{first.link,       second.link, first.collision,
                                second.collision, depth,       thickness};
      const auto [known, is_new] = deepest.try_emplace({first.link, second.link}, overlap);
      if (!is_new && depth > known->second.depth) known->second = overlap;
    }
  }
  std::vector<LinkOverlap> overlaps;
  for (const auto& [key, overlap] : deepest) overlaps.push_back(overlap);
  return overlaps;
}

}  // namespace smurf
