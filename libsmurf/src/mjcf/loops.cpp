// SPDX-License-Identifier: BSD-3-Clause
// `<connect>` and `<weld>` as joints beside the tree.
#include <algorithm>
#include <cmath>

#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

constexpr double kClosed = 1e-6;  // m and rad: closer ends meet

/// At the reference, where the joints have the values that the file draws.
Pose in_world(const Model& model, std::uint32_t body) {
  Pose X = model.bodies[body].pose;
  for (std::uint32_t at = model.bodies[body].parent; body != 0 && at != 0;
       at = model.bodies[at].parent)
    X = model.bodies[at].pose * X;
  return body == 0 ? Pose{} : X;
}

bool is_small(const Pose& X, bool heeds_turn) {
  const auto& [x, y, z] = X.position;
  const Quaternion& q = X.orientation;
  const double turn = heeds_turn ? std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z) : 0;
  return std::fabs(x) + std::fabs(y) + std::fabs(z) + turn < kClosed;
}

}  // namespace

std::optional<ClosedLoop> closed_loop(const Model& model, const PartsByName& parts,
                                      const Reference& one, const Settings& settings,
                                      Reporter& reporter) {
  // Gazebo says where a loop is closed for joints at zero, which is not where the file draws them.
  for (const Body& body : model.bodies) {
    if (std::any_of(body.joints.begin(), body.joints.end(),
                    [](const Joint& joint) { return joint.reference != 0; }))
      return std::nullopt;
  }
  ClosedLoop loop;
  const View element = one.element;
  loop.is_ball = element.name() == "connect";
  loop.element = element;
  loop.frame = one.around.frame;
  const Attribute* name = element.attribute("name");
  const Site* site1 = parts.site(element.attribute("site1"), one.around);
  const Site* site2 = parts.site(element.attribute("site2"), one.around);
  const bool has_sites = element.attribute("site1") != nullptr;
  if (has_sites && (site1 == nullptr || site2 == nullptr)) return std::nullopt;
  const auto body = [&](std::string_view which) {
    const Attribute* written = element.attribute(which);
    return written == nullptr ? std::optional<std::uint32_t>(0)  // the world
                              : parts.body(written, one.around);
  };
  const auto first = has_sites ? std::optional(site1->body) : body("body1");
  const auto second = has_sites ? std::optional(site2->body) : body("body2");
  if (!first || !second || *first == *second) return std::nullopt;
  const Pose X_21 = inverse(in_world(model, *second)) * in_world(model, *first);
  if (has_sites) {
    if (!is_small(inverse(site2->pose) * X_21 * site1->pose, !loop.is_ball)) return std::nullopt;
    loop.X_CJ = site2->pose;
  } else if (loop.is_ball) {
    Vector3 anchor{};
    settings.numbers("anchor", anchor, 3, reporter);
    loop.X_CJ = X_21 * Pose{anchor, {}};
    loop.X_CJ.orientation = {};
  } else {
    std::array<double, 7> pose{0, 0, 0, 0, 0, 0, 0};
    settings.numbers("relpose", pose, 7, reporter);
    const Pose X_12{{pose[0], pose[1], pose[2]}, {pose[3], pose[4], pose[5], pose[6]}};
    const bool is_drawn = pose[3] == 0 && pose[4] == 0 && pose[5] == 0 && pose[6] == 0;
    if (!is_drawn && !is_small(X_21 * Pose{X_12.position, normalized(X_12.orientation)}, true))
      return std::nullopt;
  }
  loop.parent = model.bodies[*first].name;
  loop.child = model.bodies[*second].name;
  loop.name = name != nullptr ? full_name(name->value(), one.around)
                              : "loop_of_" + loop.parent + "_and_" + loop.child;
  return loop;
}

}  // namespace smurf::mjcf
