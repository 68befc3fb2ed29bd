// SPDX-License-Identifier: BSD-3-Clause
#include "link/describe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"

namespace smurf {
namespace {

using Lines = std::vector<std::string>;

constexpr double kDegree = std::numbers::pi / 180;  // rad
constexpr std::size_t kMostNames = 8;               // the most items of a list in one line

std::string number(double value) {
  // Rounding errors of a sine would only distract people.
  return format_rounded(std::fabs(value) < 1e-12 ? 0 : value, 6);
}

std::string numbers(const Vector3& vector, std::string_view between = " ") {
  std::string text;
  for (const double one : vector) {
    text += (text.empty() ? std::string() : std::string(between)) + number(one);
  }
  return text;
}

std::string names_of(const std::vector<std::string_view>& names) {
  return shortlist(all_quoted(names), kMostNames);
}

bool turns(const urdf::Joint& joint) {
  return joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::continuous;
}

std::string position(double value, bool is_angle) {
  return number(value) + (is_angle ? " rad (" + in_degrees(value) + ")" : " m");
}

std::string limits_of(const urdf::Joint& joint) {
  const bool is_angle = turns(joint);
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  const urdf::Limit& limit = *joint.limit;
  const bool has_range = limit.lower || limit.upper;
  if (has_range && joint.type != urdf::JointType::continuous) {
    add("from " + position(limit.lower.value_or(0), is_angle) + " to " +
        position(limit.upper.value_or(0), is_angle));
  }
  if (limit.effort) add("at most " + number(*limit.effort) + (is_angle ? " N m" : " N"));
  if (limit.velocity) add("at most " + number(*limit.velocity) + (is_angle ? " rad/s" : " m/s"));
  return text;
}

std::string name_of(const Field<std::string>& name) {
  return name ? quoted(*name) : std::string("nothing");
}

Lines joint_lines(const LinkedModel& model, std::uint32_t item) {
  const urdf::Joint& joint = model.robot->joints[item];
  Lines lines{"joint " + name_of(joint.name) + ": " +
              (joint.type_name ? *joint.type_name : std::string("no type")) + ", from link " +
              name_of(joint.parent) + " to link " + name_of(joint.child)};
  if (joint.has_one_axis()) {
    lines.push_back("axis " + numbers(joint.axis.value_or({1, 0, 0})));
  }
  if (joint.limit) {
    const std::string limits = limits_of(joint);
    if (!limits.empty()) lines.push_back(limits);
  }
  if (joint.mimic && joint.mimic->joint) {
    lines.push_back("follows joint " + quoted(*joint.mimic->joint));
  }
  std::vector<std::string_view> motors;
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint && joint.name && *motor.joint == *joint.name && motor.name) {
      motors.push_back(*motor.name);
    }
  }
  if (!motors.empty()) lines.push_back("driven by " + names_of(motors));
  return lines;
}

Lines link_lines(const LinkedModel& model, std::uint32_t item) {
  const urdf::Link& link = model.robot->links[item];
  Lines lines{"link " + name_of(link.name)};
  if (link.inertial && link.inertial->mass) {
    lines[0] += ": " + number(*link.inertial->mass) + " kg";
    if (link.inertial->origin.xyz) {
      lines[0] += ", centre of mass at " + numbers(*link.inertial->origin.xyz) + " m";
    }
  }
  if (const auto above = model.tree.parent_joint[item]) {
    const urdf::Joint& joint = model.joint(*above);
    lines.push_back("carried by link " + name_of(joint.parent) + ", joint " + name_of(joint.name));
  } else {
    lines.emplace_back("root of the robot");
  }
  std::vector<std::string_view> carried;
  for (const JointIndex joint : model.tree.child_joints[item]) {
    if (model.joint(joint).child) carried.push_back(*model.joint(joint).child);
  }
  if (!carried.empty()) lines.push_back("carries " + names_of(carried));
  const Lines place = describe_place(model, LinkIndex{item});
  lines.insert(lines.end(), place.begin(), place.end());
  return lines;
}

Lines motor_lines(const LinkedModel& model, std::uint32_t item) {
  const Motor& motor = model.annotations.motors[item];
  Lines lines{"motor " + name_of(motor.name)};
  if (motor.type) lines[0] += ": " + *motor.type;
  if (!motor.joint) return lines;
  lines[0] += ", drives joint " + quoted(*motor.joint);
  const auto joint = model.joint_names.find(*motor.joint);
  if (joint && model.robot) {
    const Lines more = joint_lines(model, *joint);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

Lines sensor_lines(const LinkedModel& model, std::uint32_t item) {
  const Sensor& sensor = model.annotations.sensors[item];
  Lines lines{"sensor " + name_of(sensor.name)};
  if (sensor.type) lines[0] += ": " + *sensor.type;
  if (sensor.link) lines[0] += " at link " + quoted(*sensor.link);
  return lines;
}

Lines material_lines(const LinkedModel& model, std::string_view name) {
  Lines lines{"material " + quoted(name)};
  if (!model.robot) return lines;
  for (const urdf::Material& material : model.robot->materials) {
    if (!material.name || *material.name != name || !material.rgba) continue;
    const auto& c = *material.rgba;
    lines[0] += ": rgba " + numbers({c[0], c[1], c[2]}) + " " + number(c[3]);
  }
  return lines;
}

}  // namespace

std::string in_degrees(double radians) { return format_rounded(radians / kDegree, 5) + " deg"; }

std::string describe(const Pose& pose) {
  Vector3 degrees = to_rpy(pose.orientation);
  for (double& angle : degrees) angle /= kDegree;
  return "xyz " + numbers(pose.position) + "  rpy " + numbers(degrees) + " deg";
}

std::vector<std::string> describe(const LinkedModel& model, const Reference& reference) {
  if (!reference.is_known()) return {};
  switch (reference.kind) {
  case NameKind::joint: return joint_lines(model, reference.item);
  case NameKind::link: return link_lines(model, reference.item);
  case NameKind::motor: return motor_lines(model, reference.item);
  case NameKind::sensor: return sensor_lines(model, reference.item);
  case NameKind::material: return material_lines(model, reference.name);
  case NameKind::visual:
  case NameKind::collision: {
    Lines lines{std::string(to_string(reference.kind)) + " " + quoted(reference.name)};
    if (model.robot) lines[0] += " of link " + name_of(model.robot->links[reference.item].name);
    return lines;
  }
  default: return {std::string(to_string(reference.kind)) + " " + quoted(reference.name)};
  }
}

std::vector<std::string> describe(const LinkedScene& scene, const Reference& reference) {
  if (!reference.is_known()) return {};
  if (reference.kind != NameKind::entity) {
    const std::size_t model = to_size(reference.model);
    return model < scene.models.size() ? describe(scene.models[model], reference) : Lines{};
  }
  std::size_t first = 0;
  for (std::size_t file = 0; file < scene.scenes.size(); ++file) {
    const auto& entities = scene.scenes[file].scene.entities;
    const std::size_t entity = reference.item - first;
    first += entities.size();
    if (entity >= entities.size()) continue;
    Lines lines{"entity " + quoted(reference.name)};
    if (entities[entity].file) lines[0] += ": " + quoted(*entities[entity].file);
    for (const Instance& instance : scene.instances) {
      const bool is_it = to_size(scene.use(instance).scene) == file && instance.entity == entity;
      if (is_it && instance.X_WE) lines.push_back("in the world: " + describe(*instance.X_WE));
    }
    return lines;
  }
  return {};
}

std::vector<std::string> describe_place(const LinkedModel& model, LinkIndex link,
                                        const std::optional<Pose>& X_LP) {
  const std::vector<std::optional<Pose>> poses = forward_kinematics(model, {});
  if (to_size(link) >= poses.size() || !poses[to_size(link)]) return {};
  const std::string root = name_of(model.link(model.tree.roots.front()).name);
  const Pose& X_RL = *poses[to_size(link)];
  Lines lines{"seen from " + root + ", all joints at 0: " + describe(X_LP ? X_RL * *X_LP : X_RL)};
  std::vector<std::string_view> way;
  for (auto joint = model.tree.parent_joint[to_size(link)]; joint;
       joint = model.tree.parent_joint[to_size(*model.tree.joint_parent[to_size(*joint)])]) {
    if (model.joint(*joint).name) way.push_back(*model.joint(*joint).name);
  }
  std::reverse(way.begin(), way.end());
  if (!way.empty()) lines.push_back("by the joints " + names_of(way));
  if (X_LP)
    lines.push_back("and in link " + name_of(model.link(link).name) + ": " + describe(*X_LP));
  return lines;
}

std::vector<std::string> describe(const MeshFacts& mesh, const Vector3& scale) {
  const bool is_read = mesh.unread.empty();
  Lines lines{"mesh: " + std::string(to_string(mesh.format)) +
              (is_read ? ", " + counted(mesh.triangles, "triangle") : "")};
  if (!is_read) lines.push_back("the mesh " + mesh.unread);
  if (mesh.box) {
    Vector3 size = mesh.box->size();
    const double unit = mesh.unit_meters.value_or(1);
    for (std::size_t i = 0; i < size.size(); ++i) size[i] *= std::fabs(scale[i]) * unit;
    lines.push_back(numbers(size, " x ") + " m");
  }
  if (mesh.unit_meters) {
    lines.push_back("unit " + number(*mesh.unit_meters) + " m");
  } else if (mesh.box) {
    lines.emplace_back("the file contains no unit, so readers use metres");
  }
  if (mesh.defect) lines.push_back(mesh.defect->what);
  return lines;
}

}  // namespace smurf
