// SPDX-License-Identifier: BSD-3-Clause
// Visits all lists of annotations.
#pragma once

#include "smurf/model.hpp"

namespace smurf {

/// Calls `visit(list in a, the same list in b)` for each list.
template <class Visit>
void for_each_section(Annotations& a, Annotations& b, const Visit& visit) {
  visit(a.materials, b.materials);
  visit(a.motors, b.motors);
  visit(a.sensors, b.sensors);
  visit(a.controllers, b.controllers);
  visit(a.collisions, b.collisions);
  visit(a.visuals, b.visuals);
  visit(a.links, b.links);
  visit(a.nodes, b.nodes);
  visit(a.joints, b.joints);
  visit(a.joint_tasks, b.joint_tasks);
  visit(a.lights, b.lights);
  visit(a.graphics, b.graphics);
  visit(a.poses, b.poses);
  visit(a.submechanisms, b.submechanisms);
  visit(a.exoskeletons, b.exoskeletons);
  visit(a.interfaces, b.interfaces);
  visit(a.submodels, b.submodels);
  visit(a.custom, b.custom);
}

}  // namespace smurf
