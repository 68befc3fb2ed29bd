// SPDX-License-Identifier: BSD-3-Clause
#include "convert/annotation_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace smurf {

AnnotationValues::AnnotationValues(const LinkedModel& model) : model_(model) {
  const auto add = [&](const urdf::Material& material) {
    if (!material.name) return;
    // Definitions take precedence over uses, and the first definition over later ones.
    const urdf::Material*& known = materials_[*material.name];
    const bool is_definition = material.rgba || material.texture;
    if (known == nullptr || (is_definition && !known->rgba && !known->texture)) known = &material;
  };
  for (const urdf::Material& material : model.robot->materials) add(material);
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Visual& visual : link.visuals) {
      if (visual.material) add(*visual.material);
    }
  }
}

const urdf::Material* AnnotationValues::definition(std::string_view name) const {
  const auto found = materials_.find(name);
  return found == materials_.end() ? nullptr : found->second;
}

bool AnnotationValues::defines(const MaterialAnnotation& entry) const {
  // Materials without a name are not shared: each visual has its own.
  return entry.name && !entry.name->empty() && definition(*entry.name) != nullptr;
}

bool AnnotationValues::says_color(const MaterialAnnotation& entry) const {
  const urdf::Material* material = entry.name ? definition(*entry.name) : nullptr;
  if (!entry.diffuse_color) return true;  // unreadable or an old name; reported by other code
  return material != nullptr && material->rgba && *material->rgba == rgba_of(*entry.diffuse_color);
}

bool AnnotationValues::says_texture(const MaterialAnnotation& entry) const {
  const urdf::Material* material = entry.name ? definition(*entry.name) : nullptr;
  if (!entry.diffuse_texture) return true;
  return material != nullptr && material->texture.has_value();
}

const urdf::Joint* AnnotationValues::joint_of(const Motor& motor) const {
  if (!motor.joint) return nullptr;
  const urdf::Joint* joint = model_.find_joint(*motor.joint);
  return joint != nullptr && joint->has_one_axis() ? joint : nullptr;
}

const urdf::Joint* AnnotationValues::leader_of(const Motor& motor) const {
  if (!motor.mimic_motor) return nullptr;
  if (const Motor* leader = model_.find_motor(*motor.mimic_motor)) return joint_of(*leader);
  return model_.find_joint(*motor.mimic_motor);  // as Phobos writes it
}

bool AnnotationValues::says_limit(const Motor& motor, std::string_view key) const {
  const urdf::Joint* joint = joint_of(motor);
  const auto value = limit_value(key);
  if (joint == nullptr || !value) return true;
  const bool is_bound = *value == LimitValue::lower || *value == LimitValue::upper;
  const auto wanted = limit_of(motor, *value);
  if (!wanted) return true;
  // A joint without bounds turns freely, as does a motor whose commands stay within one turn.
  if (is_bound && joint->type == urdf::JointType::continuous) {
    return std::fabs(*wanted) == std::numbers::pi;
  }
  // To readers of URDF, absent bounds are 0.
  const urdf::Limit limit = joint->limit.value_or(urdf::Limit{});
  const Field<double>& written = limit_field(limit, *value);
  return written ? *written == *wanted : is_bound && *wanted == 0;
}

bool AnnotationValues::says_mimic(const Motor& motor) const {
  const urdf::Joint* joint = joint_of(motor);
  const urdf::Joint* leader = leader_of(motor);
  if (joint == nullptr || leader == nullptr || !leader->name) return true;
  if (!joint->mimic || !joint->mimic->joint) return false;
  return *joint->mimic->joint == *leader->name &&
         joint->mimic->multiplier.value_or(1) == motor.mimic_multiplier.value_or(0) &&
         joint->mimic->offset.value_or(0) == motor.mimic_offset.value_or(0);
}

const urdf::Joint* AnnotationValues::joint_of(const JointAnnotation& entry) const {
  return entry.name ? model_.find_joint(*entry.name) : nullptr;
}

std::optional<bool> AnnotationValues::says_dynamics(const JointAnnotation& entry,
                                                    yaml::View key) const {
  const auto value = dynamics_value(key.key());
  const urdf::Joint* joint = joint_of(entry);
  if (!value || joint == nullptr || !key.number()) return std::nullopt;
  const urdf::Dynamics dynamics = joint->dynamics.value_or(urdf::Dynamics{});
  const Field<double>& field =
      *value == DynamicsValue::damping ? dynamics.damping : dynamics.friction;
  return field.value_or(0) == *key.number();
}

std::array<double, 4> rgba_of(const Color& color) {
  return {color.r.value_or(0), color.g.value_or(0), color.b.value_or(0), color.a.value_or(1)};
}

std::array<double, 4> visible(std::array<double, 4> rgba) {
  for (double& part : rgba) part = std::clamp(part, 0.0, 1.0);
  return rgba;
}

std::optional<LimitValue> limit_value(std::string_view key) {
  if (key == "minValue" || key == "minPosition") return LimitValue::lower;
  if (key == "maxValue" || key == "maxPosition") return LimitValue::upper;
  if (key == "maxEffort") return LimitValue::effort;
  if (key == "maxSpeed") return LimitValue::velocity;
  return std::nullopt;
}

const Field<double>& limit_field(const urdf::Limit& limit, LimitValue value) {
  switch (value) {
  case LimitValue::lower: return limit.lower;
  case LimitValue::upper: return limit.upper;
  case LimitValue::effort: return limit.effort;
  case LimitValue::velocity: break;
  }
  return limit.velocity;
}

std::optional<double> limit_of(const Motor& motor, LimitValue value) {
  const auto first = [](const Field<double>& newer, const Field<double>& older) {
    return newer ? newer.value() : older.value();
  };
  switch (value) {
  case LimitValue::lower: return first(motor.min_position, motor.min_value);
  case LimitValue::upper: return first(motor.max_position, motor.max_value);
  case LimitValue::effort: return motor.max_effort.value();
  case LimitValue::velocity: break;
  }
  return motor.max_speed.value();
}

std::optional<DynamicsValue> dynamics_value(std::string_view key) {
  if (key == "springDamping" || key == "damping_const_constraint_axis1" || key == "damping") {
    return DynamicsValue::damping;
  }
  if (key == "friction") return DynamicsValue::friction;
  return std::nullopt;
}

}  // namespace smurf
