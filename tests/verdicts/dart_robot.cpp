// SPDX-License-Identifier: BSD-3-Clause
// Robots as DART reads them.
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/CylinderShape.hpp>
#include <dart/dynamics/DegreeOfFreedom.hpp>
#include <dart/dynamics/Joint.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/ShapeNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/utils/urdf/urdf.hpp>

#include "run_reader.hpp"

using smurf::tests::Json;
using smurf::tests::Reading;
namespace dynamics = dart::dynamics;

namespace {

template <class Vector>
Json numbers(const Vector& vector) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) out.push_back(vector.data()[i]);
  return out;
}

Json to_json(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix<double, 3, 4> matrix = pose.matrix().topRows<3>();
  return numbers(matrix);
}

Json to_json(const dynamics::Shape& shape) {
  Json out = {shape.getType()};
  if (const auto* box = dynamic_cast<const dynamics::BoxShape*>(&shape)) {
    out.push_back(numbers(box->getSize()));
  } else if (const auto* sphere = dynamic_cast<const dynamics::SphereShape*>(&shape)) {
    out.push_back(sphere->getRadius());
  } else if (const auto* cylinder = dynamic_cast<const dynamics::CylinderShape*>(&shape)) {
    out.push_back({cylinder->getRadius(), cylinder->getHeight()});
  } else if (const auto* mesh = dynamic_cast<const dynamics::MeshShape*>(&shape)) {
    out.push_back({numbers(mesh->getScale()), mesh->getMeshUri()});
  }
  return out;
}

void add_body(Json& robot, dynamics::BodyNode& body) {
  const std::string& name = body.getName();
  const dynamics::BodyNode* parent = body.getParentBodyNode();
  robot["links:" + name] = parent == nullptr ? "" : parent->getName();
  robot["poses:" + name] = to_json(body.getWorldTransform());
  robot["masses:" + name] = {body.getMass(), numbers(body.getInertia().getLocalCOM())};
  const Eigen::Matrix3d moments = body.getInertia().getMoment();
  robot["inertias:" + name] = numbers(moments);
  for (std::size_t i = 0; i < body.getNumShapeNodes(); ++i) {
    const dynamics::ShapeNode& shape = *body.getShapeNode(i);
    const std::string what = shape.getCollisionAspect() == nullptr ? "visuals:" : "collisions:";
    robot[what + name + ":" + std::to_string(i)] = {to_json(shape.getRelativeTransform()),
                                                    to_json(*shape.getShape())};
    if (const auto* look = shape.getVisualAspect()) {
      robot["colours:" + name + ":" + std::to_string(i)] = numbers(look->getRGBA());
    }
  }
}

void add_joint(Json& robot, dynamics::Joint& joint) {
  const std::string& name = joint.getName();
  robot["joints:" + name] = joint.getType();
  Json limits = Json::array(), damping = Json::array(), axes = Json::array();
  for (std::size_t i = 0; i < joint.getNumDofs(); ++i) {
    limits.push_back({joint.getPositionLowerLimit(i), joint.getPositionUpperLimit(i),
                      joint.getForceLowerLimit(i), joint.getForceUpperLimit(i),
                      joint.getVelocityLowerLimit(i), joint.getVelocityUpperLimit(i)});
    damping.push_back({joint.getDampingCoefficient(i), joint.getCoulombFriction(i)});
    const Eigen::Matrix<double, 6, 1> axis =
        joint.getRelativeJacobian().col(static_cast<Eigen::Index>(i));
    axes.push_back(numbers(axis));
  }
  if (joint.getNumDofs() == 0) return;
  robot["limits:" + name] = limits;
  robot["dynamics:" + name] = damping;
  robot["axes:" + name] = axes;
  if (const dynamics::Joint* followed = joint.getMimicJoint()) {
    robot["mimics:" + name] = {followed->getName(), joint.getMimicMultiplier(),
                               joint.getMimicOffset()};
  }
}

Reading read_robot(const std::string& file) {
  dart::utils::DartLoader loader;
  const dynamics::SkeletonPtr skeleton = loader.parseSkeleton(file);
  if (skeleton == nullptr) return {false, "no skeleton"};
  Reading reading{true};
  reading.robot["name:"] = skeleton->getName();
  for (std::size_t i = 0; i < skeleton->getNumBodyNodes(); ++i) {
    add_body(reading.robot, *skeleton->getBodyNode(i));
    add_joint(reading.robot, *skeleton->getBodyNode(i)->getParentJoint());
  }
  return reading;
}

}  // namespace

int main() { return smurf::tests::run_reader(read_robot); }
