// SPDX-License-Identifier: BSD-3-Clause
// URDFs as DART reads them.
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Joint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/urdf.hpp>

#include "robot_poses.hpp"

namespace {

void print_bodies(const char* what, const dart::dynamics::Skeleton& robot) {
  for (std::size_t i = 0; i < robot.getNumBodyNodes(); ++i) {
    const dart::dynamics::BodyNode& body = *robot.getBodyNode(i);
    const Eigen::Quaterniond q(body.getWorldTransform().linear());
    const Eigen::Vector3d p = body.getWorldTransform().translation();
    smurf::tests::print_pose(what, body.getName(), {p.x(), p.y(), p.z()},
                             {q.w(), q.x(), q.y(), q.z()});
  }
}

bool print_robot(const std::string& path) {
  dart::utils::DartLoader loader;
  const dart::dynamics::SkeletonPtr robot = loader.parseSkeleton(path);
  if (robot == nullptr) return false;
  for (std::size_t i = 0; i < robot->getNumDofs(); ++i) robot->setPosition(i, 0);
  print_bodies("pose", *robot);
  for (std::size_t i = 0; i < robot->getNumJoints(); ++i) {
    dart::dynamics::Joint& joint = *robot->getJoint(i);
    if (joint.getNumDofs() != 1) continue;
    joint.setPosition(0, smurf::tests::position_of_joint(joint.getName()));
  }
  print_bodies("moved", *robot);
  return true;
}

}  // namespace

int main(int argc, char** argv) { return smurf::tests::print_robots(argc, argv, print_robot); }
