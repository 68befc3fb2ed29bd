// SPDX-License-Identifier: BSD-3-Clause
// Lets a URDF hang and fall in DART. DART turns round shapes into triangles; robots that drop on
// them gain energy.
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
#include <dart/utils/urdf/urdf.hpp>

#include "motion.hpp"

namespace {

using namespace smurf::tests;
using dart::dynamics::SkeletonPtr;

SkeletonPtr load(const std::string& path) {
  dart::utils::DartLoader::Options options;
  // DART would give a frame without inertial 1 kg.
  constexpr double kNothing = 1e-9;
  options.mDefaultInertia = dart::dynamics::Inertia(kNothing, Eigen::Vector3d::Zero(),
                                                    Eigen::Matrix3d::Identity() * kNothing);
  dart::utils::DartLoader loader(options);
  const SkeletonPtr robot = loader.parseSkeleton(path);
  if (robot == nullptr || robot->getNumTrees() != 1) return nullptr;
  for (std::size_t i = 0; i < robot->getNumDofs(); ++i) {
    robot->getDof(i)->setDampingCoefficient(0);
    robot->getDof(i)->setCoulombFriction(0);
  }
  return robot;
}

double energy_of(const dart::dynamics::Skeleton& robot) {
  return robot.computeKineticEnergy() + robot.computePotentialEnergy();
}

dart::simulation::WorldPtr world_of(const SkeletonPtr& robot, double step) {
  const auto world = dart::simulation::World::create();
  world->setGravity(Eigen::Vector3d(0, 0, -kGravity));
  world->setTimeStep(step);
  world->addSkeleton(robot);
  for (std::size_t i = 0; i < robot->getNumDofs(); ++i) robot->setPosition(i, 0);
  return world;
}

template <class Print>
void simulate(const SkeletonPtr& robot, double step, Print print) {
  const auto world = world_of(robot, step);
  const double start = energy_of(*robot);
  run(
      step, [&] { world->step(); }, [&](double time) { print(time, energy_of(*robot) - start); });
}

SkeletonPtr load_free(const std::string& path) {
  const SkeletonPtr robot = load(path);
  robot->getRootBodyNode()->changeParentJointType<dart::dynamics::FreeJoint>();
  return robot;
}

std::string move(const std::string& path, double step, std::optional<double>) {
  const SkeletonPtr hanging = load(path);
  if (hanging == nullptr) return "is no robot of one tree";
  hanging->getRootBodyNode()->changeParentJointType<dart::dynamics::WeldJoint>();
  simulate(hanging, step, [&](double time, double energy) {
    print_hang(time, energy);
    for (std::size_t i = 0; i < hanging->getNumBodyNodes(); ++i) {
      const dart::dynamics::BodyNode& body = *hanging->getBodyNode(i);
      const Eigen::Quaterniond q(body.getWorldTransform().linear());
      const Eigen::Vector3d p = body.getWorldTransform().translation();
      print_link(time, body.getName(), {p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()});
    }
  });
  const SkeletonPtr falling = load_free(path);
  const double height = falling->getCOM().z();
  simulate(falling, step, [&](double time, double energy) {
    print_fall(time, energy, falling->getCOM().z() - height);
  });
  return {};
}

}  // namespace

int main(int argc, char** argv) { return move_robot(argc, argv, move); }
