// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/counted.hpp"
#include "link/link_overlaps.hpp"
#include "lint/body.hpp"
#include "lint/companions/srdf_queries.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1655_collisions_overlap_file {
namespace {

/// The pairs whose contacts an SRDF excludes: somebody knows of them.
class KnownPairs {
 public:
  explicit KnownPairs(const Companions& companions) {
    for_each_srdf(companions, [&](const srdf::Description& srdf) {
      for (const srdf::LinkPair& pair : srdf.pairs) {
        if (!pair.is_enabled && pair.link1 && pair.link2) {
          names_.insert(std::minmax<std::string_view>(*pair.link1, *pair.link2));
          lists_neighbours_ = lists_neighbours_ || (pair.reason && *pair.reason == "Adjacent");
        }
      }
    });
  }

  /// Whether an SRDF lists all pairs that a setup assistant finds.
  bool are_complete() const { return lists_neighbours_; }

  bool contains(const urdf::Link& a, const urdf::Link& b) const {
    return a.name && b.name && names_.contains(std::minmax<std::string_view>(*a.name, *b.name));
  }

 private:
  std::set<std::pair<std::string_view, std::string_view>> names_;
  bool lists_neighbours_ = false;
};

constexpr double kPart = 0.2;  // of the thinner shape
constexpr double kDeep = 0.4;

/// Whether the shape is its own hull, in every reader.
bool is_convex(const LinkedModel& model, const urdf::Collision& collision) {
  constexpr double kSame = 1.02;
  if (!std::holds_alternative<urdf::Mesh>(collision.geometry.shape)) return true;
  const double ratio = hull_ratio(model, collision.geometry);
  return ratio > 0 && ratio < kSame;
}

/// By link: the joint above it that lets it float, if any. Where two free bodies are, is not known.
std::vector<std::optional<JointIndex>> floating_joints(const LinkedModel& model) {
  std::vector<std::optional<JointIndex>> above(model.robot->links.size());
  for (const LinkIndex link : model.tree.order) {
    const auto joint = model.tree.parent_joint[to_size(link)];
    if (!joint) continue;
    const auto parent = model.tree.joint_parent[to_size(*joint)];
    const bool floats = model.joint(*joint).type == urdf::JointType::floating;
    above[to_size(link)] = floats ? joint : parent ? above[to_size(*parent)] : std::nullopt;
  }
  return above;
}

/// SML1520 reports it.
bool is_in_millimetres(const LinkedModel& model, const urdf::Collision& collision) {
  const std::optional<Box> box = bounding_box(model, collision.geometry);
  return box && diagonal_of(*box) > kFarthestOrigin;
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  std::vector<LinkOverlap> overlaps =
      LinkOverlaps(model).find(rest_positions(model), findings.tolerance(), kPart);
  if (overlaps.empty()) return;
  const KnownPairs known(companions);
  const auto floating = floating_joints(model);
  std::erase_if(overlaps, [&](const LinkOverlap& overlap) {
    if (floating[overlap.link] != floating[overlap.other]) return true;
    if (is_in_millimetres(model, *overlap.collision) ||
        is_in_millimetres(model, *overlap.other_collision)) {
      return true;
    }
    return known.contains(model.robot->links[overlap.link], model.robot->links[overlap.other]);
  });
  if (overlaps.empty()) return;
  const LinkOverlap& worst = *std::max_element(
      overlaps.begin(), overlaps.end(),
      [](const LinkOverlap& a, const LinkOverlap& b) { return a.depth < b.depth; });
  Diagnostic& diagnostic = findings.report(
      tag_name(model, worst.other_collision->element),
      "the collisions of " + title(model.robot->links[worst.link]) + " and " +
          title(model.robot->links[worst.other]) + " overlap by " +
          format_rounded(1000 * worst.depth, 3) + " mm while all joints are at zero");
  diagnostic.label(tag_name(model, worst.collision->element), "the other collision");
  // Of concave meshes, only the hulls may overlap.
  const auto are_convex = [&](const LinkOverlap& one) {
    return is_convex(model, *one.collision) && is_convex(model, *one.other_collision);
  };
  const bool is_sure = ranges::any_of(overlaps, [&](const LinkOverlap& one) {
    return one.depth > kDeep * one.thickness && are_convex(one);
  });
  const bool is_planned = known.are_complete() && are_convex(worst);
  if (is_sure || is_planned) diagnostic.severity = Severity::warning;
  if (is_planned) {
    const auto name_of = [&](std::size_t link) {
      return model.robot->links[link].name.value_or(std::string());
    };
    diagnostic.note("the SRDF lets MoveIt check the pair, so every plan starts in a collision");
    diagnostic.help("move the shapes apart, or add `<disable_collisions link1=\"" +
                    name_of(worst.link) + "\" link2=\"" + name_of(worst.other) +
                    "\" reason=\"Default\"/>` to the SRDF");
  }
  diagnostic.note(
      "no joint connects the two links; a simulator that lets them touch, such as MuJoCo, pushes "
      "them apart");
  if (overlaps.size() > 1) {
    diagnostic.note(counted(overlaps.size() - 1, "more pair") + " of this robot");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::changes, "pushes the links apart at the start", kRun},
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
    .tolerance = {.value = 0.01,
                  .unit = "m",
                  .meaning =
                      "the depth of an overlap; a fifth of the thinner shape, if that is less"},
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1655_collisions_overlap_file
