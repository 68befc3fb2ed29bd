// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "link/shape_hulls.hpp"
#include "lint/companions/srdf_queries.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1655_collisions_overlap_file {
namespace {

/// Robots have fewer; the work grows with the pairs.
constexpr std::size_t kMostShapes = 2000;
constexpr std::size_t kMostPairs = 5000;

/// A collision in the frame of the root.
struct Placed {
  const urdf::Collision* collision;
  std::size_t link;
  Pose X_RC;
  Box own;  ///< in the frame of the collision
  Box box;  ///< in the frame of the root
  std::optional<ConvexHull> hull = std::nullopt;
  bool has_tried = false;  ///< to make the hull

  const ConvexHull* hull_in(const LinkedModel& model) {
    if (!has_tried) hull = hull_of(model, collision->geometry);
    if (!has_tried && hull) hull = moved(*hull, X_RC);
    has_tried = true;
    return hull ? &*hull : nullptr;
  }
};

/// By link: the topmost link to which fixed joints connect it. Such links are one body.
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

/// The body that carries another one; the body itself for a root.
std::size_t carrier_of(const LinkedModel& model, const std::vector<std::size_t>& body,
                       std::size_t own) {
  const auto joint = model.tree.parent_joint[own];
  return joint ? body[to_size(*model.tree.joint_parent[to_size(*joint)])] : own;
}

/// Zero, or the bound that is nearest to it.
JointPositions rest_positions(const LinkedModel& model) {
  JointPositions positions;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool is_bounded =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!joint.name || !is_bounded || !joint.limit) return;
    const double lower = joint.limit->lower.value_or(0);
    const double upper = joint.limit->upper.value_or(0);
    if (lower > 0 && lower <= upper) positions[*joint.name] = lower;
    if (upper < 0 && lower <= upper) positions[*joint.name] = upper;
  });
  return positions;
}

std::vector<Placed> placed_collisions(const LinkedModel& model) {
  std::vector<Placed> all;
  std::size_t count = 0;
  for (const urdf::Link& link : model.robot->links) count += link.collisions.size();
  if (count < 2 || count > kMostShapes) return all;
  const auto poses = forward_kinematics(model, rest_positions(model));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i]) continue;
    for (const urdf::Collision& collision : model.robot->links[i].collisions) {
      const std::optional<Box> box = bounding_box(model, collision.geometry);
      if (!box) continue;
      const Pose X_RC = *poses[i] * urdf::to_pose(collision.origin);
      all.push_back({&collision, i, X_RC, *box, moved(*box, X_RC)});
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Placed& a, const Placed& b) { return a.box.low[0] < b.box.low[0]; });
  return all;
}

/// Whether a ball of this diameter fits into the intersection of two boxes.
bool have_room(const Box& a, const Box& b, double diameter) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::min(a.high[i], b.high[i]) - std::max(a.low[i], b.low[i]) < diameter) return false;
  }
  return true;
}

/// The same for two shapes, whose hulls are in their boxes, along the axes of both.
bool are_near(const Placed& a, const Placed& b, double least) {
  return have_room(a.own, moved(b.own, inverse(a.X_RC) * b.X_RC), least) &&
         have_room(b.own, moved(a.own, inverse(b.X_RC) * a.X_RC), least);
}

struct Overlap {
  const Placed* one;
  const Placed* other;
  double depth;
};

/// The deepest overlap of each pair of links that are no neighbours.
std::vector<Overlap> overlaps_of(const LinkedModel& model, std::vector<Placed>& all, double least) {
  const std::vector<std::size_t> body = bodies_of(model);
  std::map<std::pair<std::size_t, std::size_t>, Overlap> deepest;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size() && all[k].box.low[0] <= all[i].box.high[0]; ++k) {
      const std::size_t a = body[all[i].link];
      const std::size_t b = body[all[k].link];
      if (a == b || carrier_of(model, body, a) == b || carrier_of(model, body, b) == a) continue;
      if (!have_room(all[i].box, all[k].box, least)) continue;
      if (++pairs > kMostPairs) return {};
      if (!are_near(all[i], all[k], least)) continue;
      const ConvexHull* one = all[i].hull_in(model);
      const ConvexHull* other = one != nullptr ? all[k].hull_in(model) : nullptr;
      const double depth = other != nullptr ? overlap_of(*one, *other, least) : 0;
      if (depth == 0) continue;
      const auto key = std::minmax(all[i].link, all[k].link);
      const bool is_swapped = all[i].link > all[k].link;
      const Overlap overlap{is_swapped ? &all[k] : &all[i], is_swapped ? &all[i] : &all[k], depth};
      const auto [known, is_new] = deepest.try_emplace(key, overlap);
      if (!is_new && depth > known->second.depth) known->second = overlap;
    }
  }
  std::vector<Overlap> overlaps;
  for (const auto& [key, overlap] : deepest) overlaps.push_back(overlap);
  return overlaps;
}

/// The pairs whose contacts an SRDF excludes: somebody knows of them.
class KnownPairs {
 public:
  explicit KnownPairs(const Companions& companions) {
    for_each_srdf(companions, [&](const srdf::Description& srdf) {
      for (const srdf::LinkPair& pair : srdf.pairs) {
        if (!pair.is_enabled && pair.link1 && pair.link2) {
          names_.insert(std::minmax<std::string_view>(*pair.link1, *pair.link2));
        }
      }
    });
  }

  bool contains(const urdf::Link& a, const urdf::Link& b) const {
    return a.name && b.name && names_.contains(std::minmax<std::string_view>(*a.name, *b.name));
  }

 private:
  std::set<std::pair<std::string_view, std::string_view>> names_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  std::vector<Placed> all = placed_collisions(model);
  std::vector<Overlap> overlaps = overlaps_of(model, all, findings.tolerance());
  if (overlaps.empty()) return;
  const KnownPairs known(companions);
  std::erase_if(overlaps, [&](const Overlap& overlap) {
    return known.contains(model.robot->links[overlap.one->link],
                          model.robot->links[overlap.other->link]);
  });
  if (overlaps.empty()) return;
  const Overlap& worst =
      *std::max_element(overlaps.begin(), overlaps.end(),
                        [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
  Diagnostic& diagnostic = findings.report(
      tag_name(model, worst.other->collision->element),
      "the collisions of " + title(model.robot->links[worst.one->link]) + " and " +
          title(model.robot->links[worst.other->link]) + " overlap by " +
          format_rounded(1000 * worst.depth, 3) + " mm while all joints are at zero");
  diagnostic.label(tag_name(model, worst.one->collision->element), "the other collision");
  diagnostic.note(
      "no joint connects the two links; a simulator that lets them touch, such as MuJoCo, pushes "
      "them apart");
  if (overlaps.size() > 1) {
    diagnostic.note(counted(overlaps.size() - 1, "more pair") + " of this robot");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::takes, "pushes the links apart at the start", kRun},
    {&readers::gazebo, Effect::takes,
     "ignores contacts within a robot, unless `self_collide` is set", "sdformat 12.7.2 link.sdf"},
    {&readers::pybullet, Effect::takes,
     "ignores contacts within a robot, unless URDF_USE_SELF_COLLISION is set", kRun},
};

}  // namespace

extern constinit const Rule sml1655_collisions_overlap{
    .id = "SML1655",
    .name = "collisions-overlap",
    .severity = Severity::info,
    .summary = "Collisions of links that no joint connects overlap while all joints are at zero.",
    .why = "A simulator pushes the two links apart at the start, and a motion planner finds no "
           "valid start. Meshes count as their convex hulls, which most simulators use.",
    .remedy =
        "Shrink one of the shapes, or exclude the pair from the contacts of the simulator and, for MoveIt, with "
        "`disable_collisions` in the SRDF.",
    .sources = "Convex hulls of all collisions, placed by forward kinematics.",
    .check_companions = check,
    .tolerance = {.value = 0.01, .unit = "m", .meaning = "the depth of an overlap"},
    .facts = kFacts};

}  // namespace smurf::rules::sml1655_collisions_overlap_file
