// SPDX-License-Identifier: BSD-3-Clause
// Robots as urdfdom reads them.
#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "run_reader.hpp"

using smurf::tests::Json;
using smurf::tests::Reading;

namespace {

/// Keeps the first error.
class FirstError : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) text_ = text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

Json to_json(const urdf::Pose& pose) {
  double x = 0, y = 0, z = 0, w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  return {pose.position.x, pose.position.y, pose.position.z, w, x, y, z};
}

Json to_json(const urdf::Geometry& shape) {
  switch (shape.type) {
  case urdf::Geometry::SPHERE: return {"sphere", static_cast<const urdf::Sphere&>(shape).radius};
  case urdf::Geometry::BOX: {
    const urdf::Vector3& size = static_cast<const urdf::Box&>(shape).dim;
    return {"box", size.x, size.y, size.z};
  }
  case urdf::Geometry::CYLINDER: {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(shape);
    return {"cylinder", cylinder.radius, cylinder.length};
  }
  case urdf::Geometry::MESH: {
    const auto& mesh = static_cast<const urdf::Mesh&>(shape);
    return {"mesh", mesh.filename, mesh.scale.x, mesh.scale.y, mesh.scale.z};
  }
  }
  return {};
}

template <class Shape>
Json to_json(const Shape& shape) {
  if (shape == nullptr) return {"nothing"};
  return {shape->name, to_json(shape->origin),
          shape->geometry ? to_json(*shape->geometry) : Json("nothing")};
}

Json to_json(const urdf::MaterialSharedPtr& material) {
  if (material == nullptr) return "nothing";
  const urdf::Color& color = material->color;
  return {material->name, material->texture_filename, color.r, color.g, color.b, color.a};
}

void add_link(Json& robot, const urdf::Link& link) {
  robot["links:" + link.name] = link.parent_joint ? link.parent_joint->name : "";
  if (const auto& body = link.inertial) {
    robot["masses:" + link.name] = {body->mass, to_json(body->origin)};
    robot["inertias:" + link.name] = {body->ixx, body->ixy, body->ixz,
                                      body->iyy, body->iyz, body->izz};
  }
  for (std::size_t i = 0; i < link.visual_array.size(); ++i) {
    const std::string number = link.name + ":" + std::to_string(i);
    robot["visuals:" + number] = to_json(link.visual_array[i]);
    robot["colours:" + number] = to_json(link.visual_array[i]->material);
  }
  for (std::size_t i = 0; i < link.collision_array.size(); ++i) {
    robot["collisions:" + link.name + ":" + std::to_string(i)] = to_json(link.collision_array[i]);
  }
}

void add_joint(Json& robot, const urdf::Joint& joint) {
  const std::string& name = joint.name;
  robot["joints:" + name] = {joint.type, joint.parent_link_name, joint.child_link_name};
  robot["poses:" + name] = to_json(joint.parent_to_joint_origin_transform);
  if (joint.type != urdf::Joint::FIXED && joint.type != urdf::Joint::FLOATING) {
    robot["axes:" + name] = {joint.axis.x, joint.axis.y, joint.axis.z};
  }
  if (joint.limits) {
    robot["limits:" + name] = {joint.limits->lower, joint.limits->upper, joint.limits->effort,
                               joint.limits->velocity};
  }
  if (joint.dynamics)
    robot["dynamics:" + name] = {joint.dynamics->damping, joint.dynamics->friction};
  if (joint.mimic) {
    robot["mimics:" + name] = {joint.mimic->joint_name, joint.mimic->multiplier,
                               joint.mimic->offset};
  }
  if (joint.safety) {
    robot["safety:" + name] = {joint.safety->soft_lower_limit, joint.safety->soft_upper_limit,
                               joint.safety->k_position, joint.safety->k_velocity};
  }
  if (joint.calibration) {
    robot["calibration:" + name] = {
        joint.calibration->rising ? Json(*joint.calibration->rising) : Json(),
        joint.calibration->falling ? Json(*joint.calibration->falling) : Json()};
  }
}

Reading read_robot(const std::string& file) {
  FirstError error;
  console_bridge::useOutputHandler(&error);
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_DEBUG);
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDFFile(file);
  Reading reading{model != nullptr && model->getRoot() != nullptr, error.text()};
  if (!reading.is_taken) return reading;
  reading.robot["name:"] = model->getName();
  for (const auto& [name, link] : model->links_) add_link(reading.robot, *link);
  for (const auto& [name, joint] : model->joints_) add_joint(reading.robot, *joint);
  return reading;
}

}  // namespace

int main() { return smurf::tests::run_reader(read_robot); }
