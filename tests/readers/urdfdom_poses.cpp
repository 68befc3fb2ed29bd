// SPDX-License-Identifier: BSD-3-Clause
// URDFs as urdfdom reads them. It has no forward kinematics, so this program multiplies the
// frames.
#include <Eigen/Geometry>
#include <fstream>
#include <sstream>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "robot_poses.hpp"

namespace {

Eigen::Isometry3d to_transform(const urdf::Pose& pose) {
  double x = 0, y = 0, z = 0, w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) *
         Eigen::Quaterniond(w, x, y, z);
}

Eigen::Isometry3d motion(const urdf::Joint& joint, double position) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  switch (joint.type) {
  case urdf::Joint::REVOLUTE:
  case urdf::Joint::CONTINUOUS:
    return Eigen::Isometry3d(Eigen::AngleAxisd(position, axis.normalized()));
  case urdf::Joint::PRISMATIC: return Eigen::Isometry3d(Eigen::Translation3d(position * axis));
  default: return Eigen::Isometry3d::Identity();
  }
}

void print_link(const char* what, const urdf::Link& link, const Eigen::Isometry3d& X_WL,
                bool is_moved) {
  const Eigen::Quaterniond q(X_WL.linear());
  const Eigen::Vector3d p = X_WL.translation();
  smurf::tests::print_pose(what, link.name, {p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()});
  for (const urdf::LinkSharedPtr& child : link.child_links) {
    const urdf::Joint& joint = *child->parent_joint;
    const double position = is_moved ? smurf::tests::position_of_joint(joint.name) : 0;
    print_link(what, *child,
               X_WL * to_transform(joint.parent_to_joint_origin_transform) *
                   motion(joint, position),
               is_moved);
  }
}

bool print_robot(const std::string& path) {
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDFFile(path);
  if (model == nullptr || model->getRoot() == nullptr) return false;
  print_link("pose", *model->getRoot(), Eigen::Isometry3d::Identity(), false);
  print_link("moved", *model->getRoot(), Eigen::Isometry3d::Identity(), true);
  return true;
}

}  // namespace

int main(int argc, char** argv) { return smurf::tests::print_robots(argc, argv, print_robot); }
