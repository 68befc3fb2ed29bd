// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_joints.hpp"

#include "base/text/unique_names.hpp"
#include "write/sdf/sdf_controllers.hpp"
#include "write/sdf/sdf_names.hpp"

namespace smurf {
namespace {

/// Links and joints share one name space in SDF, but not in a URDF.
std::string joint_name(const LinkedModel& model, const urdf::Joint& joint,
                       std::string_view scope = {}) {
  if (!scope.empty() && sdf_scope(*joint.name) == scope) {
    const std::string inside = std::string(scope) + "::";
    std::string name = sdf_name(sdf_local(*joint.name, scope));
    while (model.link_names.contains(inside + name)) name += "_joint";
    return name;
  }
  std::string name = sdf_name(*joint.name);
  const auto is_taken = [&](const std::string& one) {
    return model.link_names.contains(one) ||
           (one != *joint.name && model.joint_names.contains(one));
  };
  while (is_taken(name)) name += "_joint";
  return name;
}

}  // namespace

const std::vector<std::string>& SdfJoints::links_of(const LinkedModel& model) {
  const auto [known, is_new] = links_.try_emplace(&model);
  if (!is_new) return known->second;
  const bool has_models = !is_old_ && scene_.form == SceneForm::expand;
  known->second = sdf_names(model, has_models ? &parts_of(model).tree.bodies : nullptr);
  return known->second;
}

const SdfModel& SdfJoints::parts_of(const LinkedModel& model) {
  auto& known = models_[&model];
  if (known) return *known;
  known = std::make_unique<SdfModel>(model, scene_);
  for (const auto& [span, name] : known->lost_contacts()) {
    losses_.note(kLostContacts, span, name);
  }
  return *known;
}

void SdfJoints::add_fixed_joint(const std::string& name, const std::string& parent,
                                const std::string& child) {
  xml_.open("joint", {{"name", name}, {"type", "fixed"}});
  xml_.leaf("parent", parent);
  xml_.leaf("child", child);
  xml_.close();
}

void SdfJoints::simplify(const urdf::Joint& joint, std::string_view written_as) {
  if (reported_.insert({static_cast<std::uint32_t>(joint.span.source), joint.span.begin}).second) {
    losses_.joint(joint, written_as);
  }
}

double SdfJoints::start_of(std::size_t i, const LinkedModel& model,
                           const urdf::Joint& joint) const {
  return start_position(model, joint, scene_.joint_positions(i));
}

void SdfJoints::add_joint(std::size_t i, const LinkedModel& model, const SdfJoint& one,
                          const std::string& parent, std::string_view scope) {
  using enum urdf::JointType;
  const urdf::Joint& joint = *one.joint;
  if (joint.type == floating) return;  // bodies of one model without a joint between them
  if (joint.type == planar || joint.type == unknown) simplify(joint, "fixed");
  if (joint.mimic) {
    simplify(joint, is_old_ ? "free to move, since SDF 1.6 has no `mimic`,"
                            : "free to move, since Gazebo before Harmonic ignores `mimic`,");
  }
  const std::size_t body = parts_of(model).tree.bodies[one.frame];
  const std::string& child = links_of(model)[body];
  const bool is_ball = one.kind == SdfJointKind::ball;
  const std::string type = is_ball                               ? "ball"
                           : one.kind == SdfJointKind::universal ? "universal"
                           : one.kind == SdfJointKind::screw     ? "screw"
                           : joint.type == prismatic             ? "prismatic"
                           : joint.has_one_axis()                ? "revolute"
                                                                 : "fixed";
  std::string name = joint.name ? joint_name(model, joint, scope) : sdf_name(child) + "_joint";
  if (is_ball) name.resize(name.size() - std::string_view("_x").size());
  xml_.open("joint", {{"name", name}, {"type", type}});
  const std::vector<std::optional<Pose>>& X_EL = frames_of(scene_, i, frames_);
  if (body != one.frame && type != "fixed") add_pose(inverse(*X_EL[body]) * *X_EL[one.frame]);
  xml_.leaf("parent", std::string(sdf_local(parent, scope)));
  xml_.leaf("child", std::string(sdf_local(child, scope)));
  if (one.kind == SdfJointKind::screw)
    xml_.leaf("thread_pitch", -1 / one.second->mimic->multiplier.value_or(1));
  if (!is_ball && joint.has_one_axis()) {
    const Pose X_FJ =
        one.second != nullptr ? inverse(*X_EL[one.frame]) * *X_EL[one.between] : Pose{};
    add_axis(i, model, joint, start_of(i, model, joint), X_FJ);
  }
  if (one.kind == SdfJointKind::universal)
    add_axis(i, model, *one.second, start_of(i, model, *one.second), {}, "axis2");
  UniqueNames sensors;
  parts_of(model).add_to_joint(xml_, joint, is_old_, sensors);
  xml_.close();
}

void SdfJoints::add_controllers(const LinkedModel& model) {
  for (const JointDrive& drive : sdf_drives(model, parts_of(model).tree, scene_.motors)) {
    if (xml_.is_full()) return;
    const std::string scope(sdf_scope(*drive.joint->name));
    const std::string name = joint_name(model, *drive.joint, scope);
    add_sdf_controller(xml_, drive, scope.empty() ? name : scope + "::" + name, scene_.motors);
  }
}

void SdfJoints::add_loop(std::size_t i, const LinkedModel& model, const Loop& loop) {
  const std::vector<std::optional<Pose>>& X_EL = frames_of(scene_, i, frames_);
  const std::vector<std::size_t>& bodies = parts_of(model).tree.bodies;
  const std::size_t child = bodies[loop.child];
  const bool is_hinge = loop.kind == LoopKind::hinge;
  const LoopGap gap = gap_of(loop, X_EL);
  xml_.open("joint",
            {{"name", joint_name(model, *loop.joint)}, {"type", is_hinge ? "revolute" : "fixed"}});
  add_pose(inverse(*X_EL[child]) * *X_EL[loop.parent] * loop.X_PJ *
           Pose{{}, from_axis_angle(loop.axis, gap.turn)});
  xml_.leaf("parent", links_of(model)[bodies[loop.parent]]);
  xml_.leaf("child", links_of(model)[child]);
  if (is_hinge) add_axis(i, model, *loop.joint, gap.turn);
  xml_.close();
}

void SdfJoints::add_axis(std::size_t i, const LinkedModel& model, const urdf::Joint& joint,
                         double start, const Pose& X_FJ, std::string_view element) {
  xml_.open(element);
  xml_.leaf("xyz", join_numbers(rotate(X_FJ.orientation, losses_.axis_of(joint))));
  xml_.open("limit");
  constexpr double kUnlimited = 1e16;  // SDF's default
  if (joint.type != urdf::JointType::continuous && joint.limit) {
    xml_.leaf("lower", joint.limit->lower.value_or(0) - start);
    xml_.leaf("upper", joint.limit->upper.value_or(0) - start);
  } else {
    xml_.leaf("lower", -kUnlimited);
    xml_.leaf("upper", kUnlimited);
  }
  if (joint.limit && joint.limit->effort) xml_.leaf("effort", *joint.limit->effort);
  if (joint.limit && joint.limit->velocity) xml_.leaf("velocity", *joint.limit->velocity);
  xml_.close();
  if (!is_old_ && joint.mimic) add_mimic(i, model, joint);
  const GazeboElements& gazebo = parts_of(model).gazebo;
  if (joint.dynamics || (joint.name && gazebo.has_spring(*joint.name))) {
    xml_.open("dynamics");
    xml_.leaf("damping", joint.dynamics ? joint.dynamics->damping.value_or(0) : 0);
    xml_.leaf("friction", joint.dynamics ? joint.dynamics->friction.value_or(0) : 0);
    if (joint.name) gazebo.add_to_dynamics(xml_, *joint.name);
    xml_.close();
  }
  xml_.close();
}

/// Writes the mimic element of SDF 1.11, which older libraries ignore. Positions are relative to
/// the start positions of the joints.
void SdfJoints::add_mimic(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) {
  if (!joint.mimic->joint) return;
  const auto leader = model.joint_names.find(*joint.mimic->joint);
  if (!leader || !model.robot->joints[*leader].has_one_axis()) return;
  const urdf::Joint& leading = model.robot->joints[*leader];
  if (&leading == &joint) return;
  const double multiplier = joint.mimic->multiplier.value_or(1);
  const double offset = joint.mimic->offset.value_or(0) + multiplier * start_of(i, model, leading) -
                        start_of(i, model, joint);
  const std::string_view scope = sdf_scope(joint.name.value_or({}));
  xml_.open("mimic", {{"joint", joint_name(model, leading, scope)}});
  xml_.leaf("multiplier", multiplier);
  xml_.leaf("offset", offset);
  xml_.leaf("reference", 0);
  xml_.close();
}

}  // namespace smurf
