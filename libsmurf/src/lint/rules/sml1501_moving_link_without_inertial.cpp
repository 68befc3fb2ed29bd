// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"
#include "lint/rigid_bodies.hpp"

namespace smurf::rules {
namespace {

bool is_shape_only(const LinkedModel& model) {
  for (const urdf::Link& link : model.robot->links) {
    if (link.inertial) return false;
  }
  return true;
}

void check(const LinkedModel& model, Findings& findings) {
  // A robot without any inertial is a drawing, and one fact; it is not reported link by link.
  if (!model.robot || is_shape_only(model)) return;
  const std::vector<bool> massless = massless_bodies(model);
  for (const LinkIndex link : model.tree.order) {
    const auto above = model.tree.parent_joint[to_size(link)];
    if (!above || !model.joint(*above).is_movable() || has_fixed_mass(model, link)) continue;
    Diagnostic& diagnostic = findings.report(name_place(model, model.link(link)),
                                             title(model.link(link)) + " moves and has no mass");
    if (massless[to_size(link)]) diagnostic.construct = "without-collision";
    diagnostic.labels.push_back({name_place(model, model.joint(*above)), "moved by this joint"});
  }
}

}  // namespace

extern constinit const Rule sml1501_moving_link_without_inertial{
    .id = "SML1501",
    .name = "moving-link-without-inertial",
    .severity = Severity::error,
    .summary = "A link that moves has no mass, nor has anything fixed to it.",
    .why = "sdformat (Gazebo) drops the link with everything below it, Bullet invents 1 kg, "
           "MuJoCo refuses the file or takes 1000 kg/m3, Drake and Pinocchio get a singular mass "
           "matrix.",
    .remedy = "Add an inertial.",
    .sources = "sdformat 12.3, Bullet and MuJoCo 3.14, executed; 106 of 322 files of the "
               "Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
