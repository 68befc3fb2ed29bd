// SPDX-License-Identifier: BSD-3-Clause
#include "lint/limit_queries.hpp"

#include <algorithm>

namespace smurf {

bool is_empty_limit(const LinkedModel& model, const urdf::Joint& joint) {
  if (!joint.limit || !joint.has_one_axis()) return false;
  constexpr std::string_view kNames[] = {"lower", "upper", "effort", "velocity"};
  const xml::View element(model.robot->document, joint.limit->element);
  return std::none_of(std::begin(kNames), std::end(kNames), [&](std::string_view name) {
    return element.attribute(name) != nullptr || has_slip(model, element.id(), name);
  });
}

bool has_equal_bounds(const urdf::Joint& joint) {
  const bool has_bounds =
      joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
  return has_bounds && joint.limit && joint.limit->lower && joint.limit->upper &&
         *joint.limit->lower == *joint.limit->upper;
}

}  // namespace smurf
