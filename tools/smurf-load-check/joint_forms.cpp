// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/joint_forms.hpp"

#include <string_view>

#include "lint/annotation_queries.hpp"
#include "smurf-load-check/body_plan.hpp"

namespace smurf::load_check {
namespace {

Eigen::Vector3d normalized(const Vector3& axis) { return to_eigen(axis).normalized(); }

std::optional<JointForm> form_in_urdf(const urdf::Joint& joint) {
  if (!joint.is_movable()) return std::nullopt;
  JointForm form;
  form.axis_C = normalized(joint.axis.value_or(Vector3{1, 0, 0}));
  switch (joint.type) {
  case urdf::JointType::prismatic: form.kind = JointKind::slider; break;
  case urdf::JointType::planar: form.kind = JointKind::planar; break;
  case urdf::JointType::floating: form.kind = JointKind::floating; break;
  default: break;
  }
  return form;
}

/// Numbers are those of MARS's enumeration JointType. A spine of segments is not changed.
void apply_type(std::string_view type, std::optional<JointForm>& form) {
  const auto become = [&](JointKind kind) {
    if (!form) form.emplace();
    form->kind = kind;
  };
  if (type == "hinge" || type == "1") become(JointKind::hinge);
  // The suspension of a hinge2 is a spring, which no stage checks.
  if (type == "hinge2" || type == "2" || type == "universal" || type == "5") {
    become(JointKind::universal);
  }
  if (type == "slider" || type == "3") become(JointKind::slider);
  if (type == "ball" || type == "4") become(JointKind::ball);
  if (type == "fixed" || type == "6") form.reset();
}

std::optional<Vector3> axis2_of(const LinkedModel& model, const JointAnnotation& entry) {
  const yaml::View mapping = mapping_of(model, entry);
  const yaml::View axis = mapping ? mapping.find("axis2") : yaml::View();
  if (!axis || !axis.is_mapping()) return std::nullopt;
  return Vector3{number_at(axis, "x").value_or(0), number_at(axis, "y").value_or(0),
                 number_at(axis, "z").value_or(0)};
}

}  // namespace

std::vector<std::optional<JointForm>> joint_forms(const LinkedModel& model) {
  std::vector<std::optional<JointForm>> forms;
  for (const urdf::Joint& joint : model.robot->joints) forms.push_back(form_in_urdf(joint));
  std::vector<std::optional<Pose>> X_RL;  // at zero, because annotations give their axes there
  for (const JointAnnotation& entry : model.annotations.joints) {
    const auto index = entry.name ? model.joint_names.find(*entry.name) : std::nullopt;
    if (!index) continue;
    std::optional<JointForm>& form = forms[*index];
    if (entry.type) apply_type(*entry.type, form);
    const auto child = model.tree.joint_child[*index];
    if (!form || !child) continue;
    if (entry.type) form->place = entry.type.span;
    const auto axis2 = axis2_of(model, entry);
    if (!entry.axis && !axis2) continue;
    if (X_RL.empty()) X_RL = forward_kinematics(model, {});
    if (!X_RL[to_size(*child)]) continue;
    const Quaternion to_child = inverse(*X_RL[to_size(*child)]).orientation;
    if (entry.axis) form->axis_C = normalized(rotate(to_child, *entry.axis));
    if (axis2) form->axis2_C = normalized(rotate(to_child, *axis2));
  }
  return forms;
}

}  // namespace smurf::load_check
