// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/counted.hpp"
#include "link/inertia.hpp"
#include "link/link_overlaps.hpp"
#include "link/possible_inertia.hpp"
#include "lint/copied_side.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1535_sides_not_mirrored_file {
namespace {

constexpr double kClose = 2e-3;  // m
constexpr std::size_t kFewest = 3;

double length(const Vector3& a) { return hypotenuse(a[0], a[1], a[2]); }
double distance(const Vector3& a, const Vector3& b) { return length(difference(a, b)); }
double degrees_of(double cosine) {
  constexpr double kDegree = 0.017453292519943295;  // rad
  return arc_tangent(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine) / kDegree;
}
std::string in_millimetres(double metres) { return format_rounded(1000 * metres, 2) + " mm"; }

/// The plane between the sides of a robot: where this coordinate of the root has this value.
struct Plane {
  std::size_t axis = 1;
  double at = 0;  // m

  Vector3 mirrored(Vector3 direction) const {
    direction[axis] = -direction[axis];
    return direction;
  }
  Vector3 mirrored_point(Vector3 point) const {
    point[axis] = 2 * at - point[axis];
    return point;
  }
};

/// A left and a right link, as indices of the tree.
struct Sides {
  std::size_t left, right;
};

/// What does not mirror, in words, and the places of the first.
struct Differences {
  std::string words;
  Span place{}, other{};

  void add(const std::string& what, Span right, Span left) {
    if (words.empty()) {
      place = right;
      other = left;
    }
    words += (words.empty() ? "" : ", ") + what;
  }
};

class Comparison {
 public:
  Comparison(const LinkedModel& model, Findings& findings)
      : model_(model),
        tolerance_(findings.tolerance()),
        answers_(findings.answers()),
        poses_(forward_kinematics(model, rest_positions(model))) {
    std::vector<std::string_view> names;
    std::vector<std::size_t> indices;
    for (const LinkIndex link : model.tree.order) {
      const std::size_t i = to_size(link);
      if (!poses_[i] || !model.robot->links[i].name || !model.tree.parent_joint[i]) continue;
      names.emplace_back(*model.robot->links[i].name);
      indices.push_back(i);
    }
    for (const auto& [left, right] : pairs_of_sides(names)) {
      const Sides pair{indices[left], indices[right]};
      if (!has_chain(model, std::array{pair.left, pair.right})) pairs_.push_back(pair);
    }
  }

  const std::vector<Sides>& pairs() const { return pairs_; }

  /// The plane that lies between most of the pairs.
  std::optional<Plane> plane() const {
    std::array<std::vector<double>, 3> middles;
    for (const Sides& pair : pairs_) {
      const Vector3& one = poses_[pair.left]->position;
      const Vector3& other = poses_[pair.right]->position;
      const double apart = distance(one, other);
      for (std::size_t i = 0; i < 3; ++i) {
        const bool is_along = std::fabs(std::fabs(one[i] - other[i]) - apart) < kClose;
        if (apart > kClose && is_along) middles[i].push_back((one[i] + other[i]) / 2);
      }
    }
    const auto most =
        std::max_element(middles.begin(), middles.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (most->size() < kFewest) return std::nullopt;
    std::sort(most->begin(), most->end());
    return Plane{static_cast<std::size_t>(most - middles.begin()), (*most)[most->size() / 2]};
  }

  /// None where the sides begin differently further up.
  std::optional<Differences> compare(const Sides& pair, const Plane& plane) {
    const std::size_t left = parent_of(pair.left);
    const std::size_t right = parent_of(pair.right);
    if (turned_.contains(left) || turned_.contains(right)) {
      turned_.insert({pair.left, pair.right});
      return std::nullopt;
    }
    Differences found;
    compare_joints(pair, left, right, plane, found);
    compare_bodies(pair, plane, found);
    return found;
  }

 private:
  const urdf::Joint& joint_of(std::size_t link) const {
    return model_.joint(*model_.tree.parent_joint[link]);
  }
  std::size_t parent_of(std::size_t link) const {
    return to_size(*model_.tree.joint_parent[to_size(*model_.tree.parent_joint[link])]);
  }

  void compare_joints(const Sides& pair, std::size_t left, std::size_t right, const Plane& plane,
                      Differences& found) {
    const urdf::Joint& one = joint_of(pair.left);
    const urdf::Joint& other = joint_of(pair.right);
    const Vector3& at = poses_[pair.left]->position;
    const Vector3& other_at = poses_[pair.right]->position;
    // Beside one parent, both are at their places; otherwise, at the same way from their parents.
    const double off = left == right
                           ? distance(plane.mirrored_point(at), other_at)
                           : distance(plane.mirrored(difference(at, poses_[left]->position)),
                                      difference(other_at, poses_[right]->position));
    const double way =
        left == right ? std::fabs(at[plane.axis] - plane.at) : distance(at, poses_[left]->position);
    if (off > kClose + tolerance_ * way) {
      found.add("its origin is " + in_millimetres(off) + " off", place_of_origin(other),
                place_of_origin(one));
    }
    if (one.type == other.type && one.has_one_axis()) compare_axes(pair, plane, found);
  }

  Span place_of_origin(const urdf::Joint& joint) const {
    return joint.origin.element == xml::kNoElement ? name_place(model_, joint)
                                                   : tag_name(model_, joint.origin.element);
  }
  Span place_of_axis(const urdf::Joint& joint) const {
    return joint.axis ? joint.axis.span : name_place(model_, joint);
  }

  void compare_axes(const Sides& pair, const Plane& plane, Differences& found) {
    const urdf::Joint& one = joint_of(pair.left);
    const urdf::Joint& other = joint_of(pair.right);
    const Vector3 x{1, 0, 0};
    const Vector3 a = rotate(poses_[pair.left]->orientation, one.axis.value_or(x));
    const Vector3 b = rotate(poses_[pair.right]->orientation, other.axis.value_or(x));
    if (!(length(a) > 0) || !(length(b) > 0)) return;
    // A mirror turns the sense of a rotation around.
    const double sense = one.type == urdf::JointType::prismatic ? 1 : -1;
    const double cosine = sense * dot(plane.mirrored(a), b) / (length(a) * length(b));
    constexpr double kParallel = 0.9998;  // 1.1 degrees
    if (std::fabs(cosine) < kParallel) {
      found.add("its axis is turned by " + format_rounded(degrees_of(std::fabs(cosine)), 2) +
                    " degrees",
                place_of_axis(other), place_of_axis(one));
      turned_.insert({pair.left, pair.right});
      return;
    }
    compare_limits(one, other, cosine > 0, found);
  }

  /// SML1529 reports ranges that no axis makes equal.
  void compare_limits(const urdf::Joint& one, const urdf::Joint& other, bool is_same_sense,
                      Differences& found) const {
    if (!one.limit || !other.limit) return;
    const urdf::Limit& a = *one.limit;
    const urdf::Limit& b = *other.limit;
    if (!a.lower || !a.upper || !b.lower || !b.upper) return;
    const bool are_same = have_same_bounds(a, b, tolerance_);
    const bool are_turned = have_turned_bounds(a, b, tolerance_);
    if (is_same_sense ? are_same : are_turned) return;
    if (!are_same && !are_turned) return;
    const double lower = is_same_sense ? *a.lower : -*a.upper;
    const double upper = is_same_sense ? *a.upper : -*a.lower;
    found.add("it moves from " + format_rounded(*b.lower, 4) + " to " +
                  format_rounded(*b.upper, 4) + ", and mirrored would from " +
                  format_rounded(lower, 4) + " to " + format_rounded(upper, 4),
              b.lower.span, a.lower.span);
  }

  /// Whether the part of one side is also on the other one, and not its mirror image.
  static bool are_same(const urdf::Inertial& one, const urdf::Inertial& other) {
    const Vector3 off =
        difference(urdf::to_pose(one.origin).position, urdf::to_pose(other.origin).position);
    return length(off) < kClose / 10 && tensor_of(one) == tensor_of(other);
  }

  /// SML1528 reports other masses, other distances, and values that were copied.
  void compare_bodies(const Sides& pair, const Plane& plane, Differences& found) const {
    const urdf::Link& one = model_.robot->links[pair.left];
    const urdf::Link& other = model_.robot->links[pair.right];
    if (!one.inertial || !other.inertial || !principal_moments(*one.inertial) ||
        !principal_moments(*other.inertial)) {
      return;
    }
    const double mass = one.inertial->mass.value_or(0);
    if (copied_side(one, other, answers_) || are_same(*one.inertial, *other.inertial)) return;
    if (!(mass > 0) || std::fabs(other.inertial->mass.value_or(0) - mass) > tolerance_ * mass) {
      return;
    }
    const Pose a = in_world(pair.left, *one.inertial);
    const Pose b = in_world(pair.right, *other.inertial);
    const double off = distance(plane.mirrored(a.position), b.position);
    if (off > 2 * kClose + tolerance_ * length(a.position)) {
      found.add("its centre of mass is " + in_millimetres(off) + " off",
                tag_name(model_, other.inertial->element), tag_name(model_, one.inertial->element));
      return;
    }
    Tensor wanted = rotated(tensor_of(*one.inertial), a.orientation);
    const Tensor has = rotated(tensor_of(*other.inertial), b.orientation);
    for (const std::size_t i : kMirroredProducts[plane.axis]) wanted[i] = -wanted[i];
    double worst = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      worst = std::max(worst, std::fabs(wanted[i] - has[i]));
    }
    const double part = worst / (wanted[0] + wanted[1] + wanted[2]);
    if (!(part > tolerance_)) return;
    found.add("its inertia is " + format_rounded(100 * part, 2) + " % of its size off",
              inertia_place(model_, *other.inertial), inertia_place(model_, *one.inertial));
  }

  /// From the origin of the link, along the axes of the root.
  Pose in_world(std::size_t link, const urdf::Inertial& inertial) const {
    const Pose turned{{0, 0, 0}, poses_[link]->orientation};
    return turned * urdf::to_pose(inertial.origin);
  }

  const LinkedModel& model_;
  const double tolerance_;
  ModelAnswers& answers_;
  const std::vector<std::optional<Pose>> poses_;
  std::vector<Sides> pairs_;      ///< parents first
  std::set<std::size_t> turned_;  ///< links whose frames do not mirror
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  Comparison comparison(model, findings);
  if (comparison.pairs().size() < kFewest + 1) return;
  const std::optional<Plane> plane = comparison.plane();
  if (!plane) return;
  std::vector<std::pair<Sides, Differences>> odd;
  std::size_t equal = 0;
  for (const Sides& pair : comparison.pairs()) {
    std::optional<Differences> found = comparison.compare(pair, *plane);
    if (!found) continue;
    if (found->words.empty()) {
      ++equal;
    } else {
      odd.emplace_back(pair, std::move(*found));
    }
  }
  // Of a robot that is not built as a mirror image, most pairs differ.
  constexpr std::size_t kOddOnes = 4;
  if (equal < kFewest || kOddOnes * odd.size() > equal + kOddOnes - 1) return;
  for (const auto& [pair, found] : odd) {
    Diagnostic& finding =
        findings.report(found.place, title(model.robot->links[pair.right]) + " does not mirror " +
                                         title(model.robot->links[pair.left]) + ": " + found.words);
    finding.label(found.other, "the other side");
    finding.note(counted(equal, "other pair") + " of sides " + (equal == 1 ? "mirrors" : "mirror") +
                 " each other");
    finding.help("mirror the side that is right");
    // Cameras and antennas may be anywhere.
    const urdf::Joint& joint = model.joint(*model.tree.parent_joint[pair.right]);
    if (odd.size() == 1 && joint.is_movable()) finding.severity = Severity::warning;
  }
}

}  // namespace

extern constinit const Rule sml1535_sides_not_mirrored{
    .id = "SML1535",
    .name = "sides-not-mirrored",
    .severity = Severity::info,
    .summary = "One of few pairs of sides is no mirror image, while the others are.",
    .why = "A policy or a controller that was made for one side is used for the other one, with "
           "signs changed. A hip that is 5 mm off makes the robot walk in a curve.",
    .remedy = "Mirror the joint or the inertial of the side that is right. A mirror changes the "
              "sign of one coordinate of a place, of two coordinates of the axis of a rotation, "
              "and of two products of inertia.",
    .sources = "All joints are at zero. Reported if at least three pairs mirror each other, and "
               "at most a quarter as many do not.",
    .check_model = check,
    .tolerance = {.value = 0.05, .meaning = "how much the two sides may differ, as a fraction"},
    .about = About::robot};

}  // namespace smurf::rules::sml1535_sides_not_mirrored_file
