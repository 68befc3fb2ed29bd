// SPDX-License-Identifier: BSD-3-Clause
// URDFs as libsdformat reads them: the resulting links, frames and joint axes. It does not compute
// motion.
#include <sdf/sdf.hh>

#include "robot_poses.hpp"

namespace {

template <class Element>
bool print_frame(const Element& element) {
  ignition::math::Pose3d pose;
  if (!element.SemanticPose().Resolve(pose, "__model__").empty()) return false;
  smurf::tests::print_pose("pose", element.Name(), {pose.X(), pose.Y(), pose.Z()},
                           {pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()});
  return true;
}

/// The axis in the frame of the model, as a pose without rotation.
bool print_axis(const sdf::Joint& joint) {
  const sdf::JointAxis* axis = joint.Axis();
  if (axis == nullptr) return true;
  ignition::math::Vector3d xyz;
  if (!axis->ResolveXyz(xyz, "__model__").empty()) return false;
  smurf::tests::print_pose("moved", joint.Name(), {xyz.X(), xyz.Y(), xyz.Z()}, {1, 0, 0, 0});
  return true;
}

bool print_robot(const std::string& path) {
  sdf::Root root;
  if (!root.Load(path).empty() || root.Model() == nullptr) return false;
  const sdf::Model& model = *root.Model();
  bool is_resolved = true;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    is_resolved = is_resolved && print_frame(*model.LinkByIndex(i));
  }
  for (std::uint64_t i = 0; i < model.FrameCount(); ++i) {
    is_resolved = is_resolved && print_frame(*model.FrameByIndex(i));
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    is_resolved = is_resolved && print_axis(*model.JointByIndex(i));
  }
  return is_resolved;
}

}  // namespace

int main(int argc, char** argv) {
  sdf::Console::Instance()->SetQuiet(true);
  return smurf::tests::print_robots(argc, argv, print_robot);
}
