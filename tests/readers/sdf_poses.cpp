// SPDX-License-Identifier: BSD-3-Clause
// Loads an SDF world with libsdformat and prints its contents: the world pose of every link and
// frame ("model::link x y z qw qx qy qz"), sensors in their links, joints with their ends, gravity
// and step.
#include <cstdio>
#include <filesystem>
#include <sdf/sdf.hh>

namespace {

void print(const std::string& name, const ignition::math::Pose3d& pose) {
  std::printf("pose\t%s\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n", name.c_str(), pose.X(),
              pose.Y(), pose.Z(), pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z());
}

ignition::math::Pose3d resolve(const sdf::SemanticPose& semantic) {
  ignition::math::Pose3d pose;
  for (const sdf::Error& error : semantic.Resolve(pose)) {
    std::fprintf(stderr, "%s\n", error.Message().c_str());
  }
  return pose;
}

void print(const sdf::Model& model, const ignition::math::Pose3d& X_WP, const std::string& outer) {
  const std::string scope = outer + model.Name();
  const ignition::math::Pose3d X_WM = X_WP * resolve(model.SemanticPose());
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link& link = *model.LinkByIndex(i);
    print(scope + "::" + link.Name(), X_WM * resolve(link.SemanticPose()));
    for (std::uint64_t k = 0; k < link.SensorCount(); ++k) {
      const sdf::Sensor& sensor = *link.SensorByIndex(k);
      const ignition::math::Vector3d at = resolve(sensor.SemanticPose()).Pos();
      std::printf("sensor\t%s::%s::%s\t%.9g\t%.9g\t%.9g\n", scope.c_str(), link.Name().c_str(),
                  sensor.Name().c_str(), at.X(), at.Y(), at.Z());
    }
  }
  for (std::uint64_t i = 0; i < model.FrameCount(); ++i) {
    const sdf::Frame& frame = *model.FrameByIndex(i);
    print(scope + "::" + frame.Name(), X_WM * resolve(frame.SemanticPose()));
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    const sdf::Joint& joint = *model.JointByIndex(i);
    std::printf("joint\t%s::%s\t%s\t%s\n", scope.c_str(), joint.Name().c_str(),
                joint.ParentLinkName().c_str(), joint.ChildLinkName().c_str());
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    print(*model.ModelByIndex(i), X_WM, scope + "::");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  // As in Gazebo, files are looked up beside the world.
  const std::filesystem::path folder = std::filesystem::absolute(argv[1]).parent_path();
  sdf::setFindCallback([&](const std::string& uri) { return (folder / uri).string(); });
  sdf::Root root;
  const sdf::Errors errors = root.Load(argv[1]);
  for (const sdf::Error& error : errors) std::fprintf(stderr, "%s\n", error.Message().c_str());
  if (!errors.empty() || root.WorldCount() != 1) return 1;
  const sdf::World& world = *root.WorldByIndex(0);
  std::printf("gravity\t%.17g\t%.17g\t%.17g\n", world.Gravity().X(), world.Gravity().Y(),
              world.Gravity().Z());
  std::printf("step\t%.17g\n", world.PhysicsDefault()->MaxStepSize());
  for (std::uint64_t i = 0; i < world.LightCount(); ++i) {
    std::printf("light\t%s\n", world.LightByIndex(i)->Name().c_str());
  }
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) print(*world.ModelByIndex(i), {}, "");
  return 0;
}
