// SPDX-License-Identifier: BSD-3-Clause
// Robots as libsdformat reads them. If it reports an error, Gazebo does not load the model.
#include <sdf/sdf.hh>

#include "run_reader.hpp"

using smurf::tests::Json;
using smurf::tests::Reading;

namespace {

Json to_json(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

Json to_json(const ignition::math::Pose3d& pose) {
  return {pose.X(),       pose.Y(),       pose.Z(),      pose.Rot().W(),
          pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()};
}

Json to_json(const ignition::math::Color& color) {
  return {color.R(), color.G(), color.B(), color.A()};
}

template <class Element>
Json pose_of(const Element& element) {
  ignition::math::Pose3d pose;
  const bool is_known = element.SemanticPose().Resolve(pose, "__model__").empty();
  return is_known ? to_json(pose) : Json("unknown");
}

Json to_json(const sdf::Geometry& shape) {
  switch (shape.Type()) {
  case sdf::GeometryType::BOX: return {"box", to_json(shape.BoxShape()->Size())};
  case sdf::GeometryType::SPHERE: return {"sphere", shape.SphereShape()->Radius()};
  case sdf::GeometryType::CYLINDER:
    return {"cylinder", shape.CylinderShape()->Radius(), shape.CylinderShape()->Length()};
  case sdf::GeometryType::MESH:
    return {"mesh", shape.MeshShape()->Uri(), to_json(shape.MeshShape()->Scale())};
  default: return {"nothing"};
  }
}

void add_link(Json& robot, const sdf::Link& link) {
  const std::string& name = link.Name();
  const auto& body = link.Inertial();
  const auto& matrix = body.MassMatrix();
  robot["links:" + name] = link.Element()->Get<bool>("gravity", true).first;
  robot["poses:" + name] = pose_of(link);
  robot["masses:" + name] = {matrix.Mass(), to_json(body.Pose())};
  robot["inertias:" + name] = {to_json(matrix.DiagonalMoments()),
                               to_json(matrix.OffDiagonalMoments())};
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Visual& visual = *link.VisualByIndex(i);
    const std::string number = name + ":" + std::to_string(i);
    robot["visuals:" + number] = {visual.Name(), pose_of(visual), to_json(*visual.Geom())};
    const sdf::Material* material = visual.Material();
    robot["colours:" + number] =
        material == nullptr ? Json()
                            : Json{to_json(material->Diffuse()), to_json(material->Ambient())};
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& collision = *link.CollisionByIndex(i);
    robot["collisions:" + name + ":" + std::to_string(i)] = {collision.Name(), pose_of(collision),
                                                             to_json(*collision.Geom())};
    const sdf::ElementPtr surface = collision.Element()->FindElement("surface");
    if (surface) robot["contact:" + name + ":" + std::to_string(i)] = surface->ToString("");
  }
}

void add_joint(Json& robot, const sdf::Joint& joint) {
  const std::string& name = joint.Name();
  robot["joints:" + name] = {static_cast<int>(joint.Type()), joint.ParentLinkName(),
                             joint.ChildLinkName()};
  const sdf::JointAxis* axis = joint.Axis();
  if (axis == nullptr) return;
  robot["axes:" + name] = to_json(axis->Xyz());
  robot["limits:" + name] = {axis->Lower(), axis->Upper(), axis->Effort(), axis->MaxVelocity()};
  robot["dynamics:" + name] = {axis->Damping(), axis->Friction(), axis->SpringStiffness(),
                               axis->SpringReference()};
  const sdf::ElementPtr physics = joint.Element()->FindElement("physics");
  if (physics) robot["physics:" + name] = physics->ToString("");
}

/// Does the same as sdf::Root::Load(file), but reads the description of SDF only once.
sdf::Errors load(const std::string& file, const sdf::SDFPtr& description, sdf::Root& root) {
  sdf::Errors errors;
  if (!sdf::readFile(file, description, errors)) {
    errors.emplace_back(sdf::ErrorCode::FILE_READ, "Unable to read file");
    return errors;
  }
  const sdf::Errors more = root.Load(description);
  errors.insert(errors.end(), more.begin(), more.end());
  return errors;
}

Reading read_robot(const std::string& file, const sdf::SDFPtr& description) {
  sdf::Root root;
  const sdf::Errors errors = load(file, description, root);
  if (!errors.empty()) return {false, errors.front().Message()};
  if (root.Model() == nullptr) return {false, "no model"};
  const sdf::Model& model = *root.Model();
  Reading reading{true};
  reading.robot["name:"] = model.Name();
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    add_link(reading.robot, *model.LinkByIndex(i));
  }
  for (std::uint64_t i = 0; i < model.FrameCount(); ++i) {
    const sdf::Frame& frame = *model.FrameByIndex(i);
    reading.robot["frames:" + frame.Name()] = {frame.AttachedTo(), pose_of(frame)};
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    add_joint(reading.robot, *model.JointByIndex(i));
  }
  return reading;
}

}  // namespace

int main() {
  sdf::Console::Instance()->SetQuiet(true);
  const sdf::SDFPtr description(new sdf::SDF());
  if (!sdf::init(description)) return 1;
  return smurf::tests::run_reader(
      [&](const std::string& file) { return read_robot(file, description); });
}
