// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/joint_inertia.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/numbers/vectors.hpp"
#include "write/parts/body_inertia.hpp"

namespace smurf {
namespace {

/// More joints than robots have. Beyond, each joint is taken to carry its own link only, which is
/// less than what it carries.
constexpr std::size_t kMostAxes = 300;

Eigen::Vector3d vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

/// A body in the frame of the root.
struct Body {
  double mass = 0;
  Eigen::Vector3d center;
  Eigen::Matrix3d tensor;
};

Body body_in_root(const LinkInertial& given, const Pose& X_RL) {
  LinkInertial turned = given;
  turned.X_LC = X_RL * given.X_LC;
  const auto [xx, yy, zz, xy, xz, yz] = tensor_in_link(turned);
  Body body{given.mass, vector(turned.X_LC.position), {}};
  body.tensor << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return body;
}

/// What an axis moves: the speed of a point per rad/s or m/s.
struct Axis {
  std::optional<std::size_t> joint;
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero(),
                  place = Eigen::Vector3d::Zero();

  Eigen::Vector3d speed_at(const Eigen::Vector3d& point) const {
    return shift + turn.cross(point - place);
  }
};

class InertiaOfJoints {
 public:
  InertiaOfJoints(const LinkedModel& model, const std::vector<std::optional<Pose>>& poses,
                  const std::vector<std::optional<LinkInertial>>& masses, bool is_free,
                  double gravity)
      : model_(model), poses_(poses), masses_(masses), gravity_(gravity) {
    if (!is_free) return;
    for (int i = 0; i < 3; ++i) {
      axes_.push_back({.joint = {}, .shift = Eigen::Vector3d::Unit(i)});
      axes_.push_back({.joint = {}, .turn = Eigen::Vector3d::Unit(i)});
    }
    base_ = axes_.size();
  }

  std::vector<JointInertia> run() {
    std::vector<JointInertia> found(model_.robot->joints.size());
    find_axes();
    if (axes_.size() > kMostAxes) {
      for (std::size_t at = base_; at < axes_.size(); ++at) found[*axes_[at].joint] = alone(at);
      return found;
    }
    const auto count = static_cast<Eigen::Index>(axes_.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
    for (const LinkIndex link : model_.tree.order) add_body(to_size(link), M, weights);
    const Eigen::LLT<Eigen::MatrixXd> factor(M);
    const bool is_sound = count > 0 && factor.info() == Eigen::Success;
    const Eigen::MatrixXd inverse =
        is_sound ? Eigen::MatrixXd(factor.solve(Eigen::MatrixXd::Identity(count, count)))
                 : Eigen::MatrixXd();
    for (std::size_t at = base_; at < axes_.size(); ++at) {
      const auto i = static_cast<Eigen::Index>(at);
      JointInertia& of_joint = found[*axes_[at].joint];
      of_joint.locked = M(i, i);
      of_joint.free = is_sound && inverse(i, i) > 0 ? 1 / inverse(i, i) : alone(at).free;
      of_joint.gravity = gravity_ * weights[i];
    }
    return found;
  }

 private:
  /// The axes above each link, those near the root first.
  void find_axes() {
    above_.resize(model_.robot->links.size());
    for (const LinkIndex link : model_.tree.order) {
      const std::size_t at = to_size(link);
      const auto& parent_joint = model_.tree.parent_joint[at];
      if (!parent_joint || !poses_[at]) {
        for (std::size_t i = 0; i < base_; ++i) above_[at].push_back(i);
        continue;
      }
      const urdf::Joint& joint = model_.joint(*parent_joint);
      above_[at] = above_[to_size(*model_.tree.joint_parent[to_size(*parent_joint)])];
      const std::optional<Vector3> written =
          joint.has_one_axis() ? joint_axis(joint) : std::nullopt;
      if (!written) continue;
      const Eigen::Vector3d axis = vector(rotate(poses_[at]->orientation, *written)).normalized();
      Axis& added = axes_.emplace_back(Axis{.joint = to_size(*parent_joint)});
      added.place = vector(poses_[at]->position);
      (joint.type == urdf::JointType::prismatic ? added.shift : added.turn) = axis;
      if (axes_.size() <= kMostAxes) above_[at].push_back(axes_.size() - 1);
      carried_.resize(axes_.size());
      carried_.back() = at;
    }
  }

  std::optional<Body> body_of(std::size_t link) const {
    if (!poses_[link] || !masses_[link]) return std::nullopt;
    return body_in_root(*masses_[link], *poses_[link]);
  }

  void add_body(std::size_t link, Eigen::MatrixXd& M, Eigen::VectorXd& weights) const {
    const std::optional<Body> body = body_of(link);
    if (!body) return;
    for (const std::size_t a : above_[link]) {
      const Eigen::Vector3d speed = axes_[a].speed_at(body->center);
      weights[static_cast<Eigen::Index>(a)] += body->mass * speed.norm();
      for (const std::size_t b : above_[link]) {
        M(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) +=
            body->mass * speed.dot(axes_[b].speed_at(body->center)) +
            axes_[a].turn.dot(body->tensor * axes_[b].turn);
      }
    }
  }

  /// An axis with the link that it carries, and nothing else.
  JointInertia alone(std::size_t at) const {
    const std::optional<Body> body = body_of(carried_[at]);
    if (!body) return {};
    const Eigen::Vector3d speed = axes_[at].speed_at(body->center);
    const double inertia =
        body->mass * speed.squaredNorm() + axes_[at].turn.dot(body->tensor * axes_[at].turn);
    return {inertia, inertia, gravity_ * body->mass * speed.norm()};
  }

  const LinkedModel& model_;
  const std::vector<std::optional<Pose>>& poses_;
  const std::vector<std::optional<LinkInertial>>& masses_;
  double gravity_;
  std::size_t base_ = 0;  ///< the number of axes of a free base
  std::vector<Axis> axes_;
  std::vector<std::vector<std::size_t>> above_;  ///< by link
  std::vector<std::size_t> carried_;             ///< by axis, the link
};

}  // namespace

std::vector<JointInertia> joint_inertias(const LinkedModel& model,
                                         const std::vector<std::optional<Pose>>& poses,
                                         const std::vector<std::optional<LinkInertial>>& masses,
                                         bool is_free, double gravity) {
  return InertiaOfJoints(model, poses, masses, is_free, gravity).run();
}

}  // namespace smurf
