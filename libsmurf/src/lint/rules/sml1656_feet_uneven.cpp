// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "link/shape_hulls.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1656_feet_uneven_file {
namespace {

/// A link on which a robot may stand.
struct Foot {
  const urdf::Link* link;
  double height;  ///< of its lowest point above the root, m; infinite where no joint leads to it
};

/// The lowest point of all collisions. None if there are none, or if a size is unknown.
std::optional<double> lowest_point(const LinkedModel& model, const urdf::Link& link,
                                   const Pose& X_RL) {
  std::optional<double> lowest;
  for (const urdf::Collision& collision : link.collisions) {
    const Pose X_RS = X_RL * urdf::to_pose(collision.origin);
    const Vector3 down = rotate(inverse(X_RS).orientation, {0, 0, -1});
    const std::optional<double> reach = reach_of(model, collision.geometry, down);
    if (!reach || !std::isfinite(*reach)) return std::nullopt;
    const double height = X_RS.position[2] - *reach;
    lowest = lowest ? std::min(*lowest, height) : height;
  }
  return lowest;
}

void report(const LinkedModel& model, const Foot& low, const Foot& high, Findings& findings) {
  Diagnostic& diagnostic = findings.report(
      name_place(model, *high.link),
      title(*high.link) + " ends " + format_rounded(1000 * (high.height - low.height), 3) +
          " mm above " + title(*low.link) + " while all joints are at zero");
  diagnostic.label(name_place(model, *low.link), "the lower one");
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::vector<std::size_t> links;
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    const urdf::Link& link = model.robot->links[i];
    if (!link.name || link.collisions.empty()) continue;
    links.push_back(i);
    names.emplace_back(*link.name);
  }
  const auto pairs = pairs_of_sides(names);
  if (pairs.empty()) return;
  const auto poses = forward_kinematics(model, {});
  std::vector<Foot> feet;
  double ground = std::numeric_limits<double>::infinity();
  for (const std::size_t i : links) {
    const urdf::Link& link = model.robot->links[i];
    feet.push_back({&link, std::numeric_limits<double>::infinity()});
    if (i >= poses.size() || !poses[i]) continue;
    const std::optional<double> height = lowest_point(model, link, *poses[i]);
    if (!height) return;  // it may be the one that stands on the ground
    ground = std::min(ground, *height);
    feet.back().height = *height;
  }
  constexpr double kNear = 0.01;  // m; a link that ends this near to the ground stands on it
  for (const auto& [left, right] : pairs) {
    const bool is_left_lower = feet[left].height < feet[right].height;
    const Foot& low = is_left_lower ? feet[left] : feet[right];
    const Foot& high = is_left_lower ? feet[right] : feet[left];
    if (!std::isfinite(high.height)) continue;
    if (low.height > ground + kNear || !(high.height - low.height > findings.tolerance())) continue;
    report(model, low, high, findings);
  }
}

}  // namespace

extern constinit const Rule sml1656_feet_uneven{
    .id = "SML1656",
    .name = "feet-uneven",
    .severity = Severity::info,
    .summary =
        "Two feet or wheels of a robot end at different heights while all joints are at zero.",
    .why = "The robot stands on one of them only, and tips over at the start of a simulation.",
    .remedy = "Compare the origins of the joints and collisions of both.",
    .sources = "The lowest points of collisions, placed by forward kinematics.",
    .check_model = check,
    .tolerance = {.value = 0.002, .unit = "m", .meaning = "how much the heights may differ"},
    .about = About::robot};

}  // namespace smurf::rules::sml1656_feet_uneven_file
