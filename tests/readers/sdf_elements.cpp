// SPDX-License-Identifier: BSD-3-Clause
// Loads URDFs and SDF worlds with libsdformat and prints the first model of each: the poses of
// links, shapes, sensors and joints in the frame of the model, inertias in the frame of their link,
// and the model as the XML that Gazebo sees.
#include <cstdio>
#include <sdf/sdf.hh>

namespace {

using ignition::math::Pose3d;

void print(const char* kind, const std::string& name, const Pose3d& pose) {
  std::printf("%s\t%s\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\n", kind, name.c_str(), pose.X(),
              pose.Y(), pose.Z(), pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z());
}

template <class Element>
Pose3d pose_of(const Element& element, const std::string& frame) {
  Pose3d pose;
  (void)element.SemanticPose().Resolve(pose, frame);
  return pose;
}

void print(const sdf::Link& link) {
  const Pose3d X_ML = pose_of(link, "__model__");
  print("link", link.Name(), X_ML);
  const auto& body = link.Inertial();
  const ignition::math::Matrix3d moments = body.Moi();
  std::printf("inertia\t%s\t%.9g", link.Name().c_str(), body.MassMatrix().Mass());
  for (int i = 0; i < 3; ++i) std::printf("\t%.9g", body.Pose().Pos()[i]);
  for (int i = 0; i < 9; ++i) std::printf("\t%.9g", moments(i / 3, i % 3));
  std::printf("\n");
  const std::string scope = link.Name() + "::";
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Visual& one = *link.VisualByIndex(i);
    print("visual", scope + one.Name(), X_ML * pose_of(one, link.Name()));
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& one = *link.CollisionByIndex(i);
    print("collision", scope + one.Name(), X_ML * pose_of(one, link.Name()));
  }
  for (std::uint64_t i = 0; i < link.SensorCount(); ++i) {
    const sdf::Sensor& one = *link.SensorByIndex(i);
    print("sensor", scope + one.Name(), X_ML * pose_of(one, link.Name()));
  }
}

void print(const sdf::Joint& joint) {
  const Pose3d X_MJ = pose_of(joint, "__model__");
  for (unsigned int i = 0; i < 2; ++i) {
    if (joint.Axis(i) == nullptr) continue;
    ignition::math::Vector3d axis;
    (void)joint.Axis(i)->ResolveXyz(axis, "__model__");
    print("axis", joint.Name(), Pose3d(axis, ignition::math::Quaterniond::Identity));
  }
  print("joint", joint.Name(), X_MJ);
  for (std::uint64_t i = 0; i < joint.SensorCount(); ++i) {
    const sdf::Sensor& one = *joint.SensorByIndex(i);
    print("sensor", joint.Name() + "::" + one.Name(), X_MJ * pose_of(one, joint.Name()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  sdf::setFindCallback([](const std::string& uri) { return uri; });
  for (int i = 1; i < argc; ++i) {
    std::printf("file\t%s\n", argv[i]);
    sdf::Root root;
    const sdf::Errors errors = root.Load(argv[i]);
    for (const sdf::Error& error : errors) std::printf("error\t%s\n", error.Message().c_str());
    const sdf::World* world = root.WorldCount() > 0 ? root.WorldByIndex(0) : nullptr;
    const sdf::Model* model = root.Model();
    if (world != nullptr && world->ModelCount() > 0) model = world->ModelByIndex(0);
    if (model != nullptr) {
      for (std::uint64_t k = 0; k < model->LinkCount(); ++k) print(*model->LinkByIndex(k));
      for (std::uint64_t k = 0; k < model->JointCount(); ++k) print(*model->JointByIndex(k));
      std::printf("xml\n%s\n", model->Element()->ToString("").c_str());
    }
    std::printf("end\n");
    std::fflush(stdout);
  }
}
