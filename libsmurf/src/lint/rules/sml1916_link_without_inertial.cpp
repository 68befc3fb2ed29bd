// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1916_link_without_inertial_file {
namespace {

constexpr Circumstance kRoot{"root"};
constexpr Circumstance kOfShapes{"with collisions, in a moving body"};

/// Reported as a whole (SML1502).
bool is_without_mass(const LinkedModel& model) {
  const std::vector<urdf::Link>& links = model.robot->links;
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  return std::none_of(links.begin(), links.end(),
                      [](const urdf::Link& link) { return link.inertial.has_value(); }) &&
         std::any_of(joints.begin(), joints.end(),
                     [](const urdf::Joint& joint) { return joint.is_movable(); });
}

/// True when the mass is a number, if one that is too large to be computed with.
bool is_number(const LinkedModel& model, const urdf::Inertial& inertial) {
  const xml::View mass = xml::View(model.robot->document, inertial.element).child("mass");
  const xml::Attribute* value = mass ? mass.attribute("value") : nullptr;
  return value != nullptr && parse_number(value->value()).has_value();
}

/// Links have no mass either when numbers in an inertial cannot be read, for readers that then drop
/// them.
void check_unread_masses(const LinkedModel& model, Findings& findings) {
  if (model.tree.roots.size() != 1 || !is_left_without_links(model)) return;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::optional<urdf::Inertial>& inertial = link.inertial;
    if (!inertial) return;
    if (!has_exact_name(model, *inertial)) {
      return findings.add_consequence(tag_name(model, inertial->element));
    }
    const Field<double>& mass = inertial->mass;
    if (!mass && !is_number(model, *inertial)) {  // a mass of 0 is another finding
      findings.add_consequence(mass.written ? mass.span : tag_name(model, inertial->element));
    }
    for (const auto* part : {&inertial->origin.xyz, &inertial->origin.rpy}) {
      if (part->written && !*part) findings.add_consequence(part->span);
    }
  });
}

/// True when sdformat drops the root, or all links below a root that is the world.
bool loses_all(const LinkedModel& model) {
  const LinkIndex root = model.tree.roots.front();
  const urdf::Link& link = model.link(root);
  const bool is_light = link.name.value_or("") == "world" || !link.inertial;
  return !has_fixed_mass(model, root) || (is_light && is_left_without_links(model));
}

/// The topmost link without an inertial, if all is lost with it.
std::optional<std::size_t> first_lost(const LinkedModel& model) {
  if (model.tree.roots.size() != 1 || !loses_all(model)) return std::nullopt;
  const LinkIndex root = model.tree.roots.front();
  if (model.link(root).name.value_or("") != "world") return to_size(root);
  for (const JointIndex below : model.tree.child_joints[to_size(root)]) {
    const LinkIndex link = *model.tree.joint_child[to_size(below)];
    if (!model.link(link).inertial) return to_size(link);
  }
  return std::nullopt;
}

/// One finding per file, because exporters leave the inertials of all frames out.
void check(const LinkedModel& model, Findings& findings) {
  if (model.robot) check_unread_masses(model, findings);
  if (!model.robot || is_without_mass(model)) return;
  // The root speaks for the others, if all is lost with it.
  const std::optional<std::size_t> first = first_lost(model);
  std::optional<BodiesOfMujoco> bodies;  // computed when they are needed
  const auto report = [&](std::size_t index) {
    const urdf::Link& link = model.robot->links[index];
    if (link.inertial || link.name.value_or("") == "world") return;
    if (!bodies) bodies.emplace(model);
    Diagnostic& finding = findings.report_habit(name_place(model, link),
                                                title(link) + " has no inertial", "such links");
    if (index == first) finding.when(kRoot);
    if (bodies->is_massless(index)) finding.when(kMasslessBody);
    if (bodies->adds_mass_of_shapes(index)) finding.when(kOfShapes);
  };
  if (first) report(*first);
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    if (i != first) report(i);
  }
}

constexpr std::string_view kDropsRoot =
    "drops the root with everything below it: a model without links";

constexpr Fact kFacts[] = {
    {&readers::pybullet,
     Effect::changes,
     "gives each such link 1 kg, and computes its inertia from the collisions",
     kRun,
     {},
     "add an inertial to every link, a small one to frames and sensors"},
    {&readers::gazebo, Effect::refuses, kDropsRoot, kRun, when(kRoot)},
    {&readers::gazebo, Effect::refuses, kDropsRoot, kRun, at("inertial")},
    {&readers::dart,
     Effect::changes,
     "gives each such link 1 kg and 1 kg m2",
     kRun,
     {},
     "add an inertial to every link, a small one to frames and sensors"},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass or collision", kRun,
     when(kMasslessBody)},
    {&readers::mujoco, Effect::changes,
     "adds the mass of its collisions, as dense as water, to the body that it is fixed to",
     "2.3.7 to 4.0.0, run", when(kOfShapes)},
};

}  // namespace

extern constinit const Rule sml1916_link_without_inertial{
    .id = "SML1916",
    .name = "link-without-inertial",
    .severity = Severity::warning,
    .summary = "A link has no inertial: a target invents one, or drops the link.",
    .why = "In URDF this means no mass, as for frames and sensors.",
    .remedy = "Add an inertial to every link that has a mass.",
    .sources = "bullet3 issues 3097, 3110; 102 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1916_link_without_inertial_file
