// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/readers.hpp"
#include "lint/queries.hpp"
#include "lint/rigid_bodies.hpp"

namespace smurf::rules {
namespace {

/// Reported as a whole (SML1502).
bool is_without_mass(const LinkedModel& model) {
  const std::vector<urdf::Link>& links = model.robot->links;
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  return std::none_of(links.begin(), links.end(),
                      [](const urdf::Link& link) { return link.inertial.has_value(); }) &&
         std::any_of(joints.begin(), joints.end(),
                     [](const urdf::Joint& joint) { return joint.is_movable(); });
}

/// The root has no inertial either when numbers in it cannot be read, for readers that then drop
/// it.
void check_unreadable_root(const LinkedModel& model, Findings& findings) {
  constexpr double kDropped = 1e-6;  // kg; sdformat drops bodies up to this
  if (model.tree.roots.size() != 1) return;
  const LinkIndex root = model.tree.roots.front();
  const std::optional<urdf::Inertial>& inertial = model.link(root).inertial;
  if (!inertial || masses_of_bodies(model)[to_size(root)] > kDropped) return;
  const Field<double>& own = inertial->mass;
  if (own) return;  // a mass of 0 is another finding
  findings.add_consequence(own.written ? own.span : tag_name(model, inertial->element));
}

void check(const LinkedModel& model, Findings& findings) {
  if (model.robot) check_unreadable_root(model, findings);
  std::vector<const urdf::Link*> links;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial && link.name.value_or("") != "world") links.push_back(&link);
  });
  if (links.empty() || is_without_mass(model)) return;
  const bool has_root = model.tree.roots.size() == 1;
  const bool is_root_lost = has_root && !has_fixed_mass(model, model.tree.roots.front());
  const urdf::Link& shown = is_root_lost ? model.link(model.tree.roots.front()) : *links.front();
  Diagnostic& diagnostic =
      findings.report(name_place(model, shown), title(shown) + " has no inertial");
  if (is_root_lost) diagnostic.construct = "root";
  // SML1501 reports single links only when some other link has an inertial.
  const std::vector<bool> massless = massless_bodies(model);
  if (std::find(massless.begin(), massless.end(), true) != massless.end()) {
    diagnostic.construct += "#massless-body";
  }
  if (links.size() > 1) {
    diagnostic.notes.push_back(std::to_string(links.size() - 1) + " more links have none");
  }
}

constexpr std::string_view kDropsRoot =
    "drops the root with everything below it: a model without links";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "gives each such link 1 kg and 1 kg m2",
     "Bullet UrdfParser.cpp:1051-1059"},
    {&readers::gazebo, Effect::refuses, kDropsRoot, kRun, "#root"},
    {&readers::gazebo, Effect::refuses, kDropsRoot, kRun, "/inertial/"},
    {&readers::dart, Effect::changes, "gives each such link 1 kg and 1 kg m2", kRun},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass or collision", kRun,
     "#massless-body"},
};

}  // namespace

extern constinit const Rule sml1916_link_without_inertial{
    .id = "SML1916",
    .name = "link-without-inertial",
    .severity = Severity::warning,
    .summary = "A link has no inertial: a target invents one, or drops the link.",
    .why = "In URDF this means no mass, as for frames and sensors.",
    .remedy =
        "Add an inertial to every link that has a mass, and for Bullet a small one to every frame.",
    .sources = "bullet3 issues 3097, 3110; 102 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules
