// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1915_mimic_unread_file {
namespace {

/// A motor couples each of the joints.
constexpr Circumstance kCoupled{"coupled by motors"};

/// The joints whose motors follow another motor.
std::set<std::string, std::less<>> coupled_joints(const LinkedModel& model) {
  std::set<std::string, std::less<>> coupled;
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint && motor.mimic_motor) coupled.insert(*motor.joint);
  }
  return coupled;
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<const urdf::Joint*> mimics, coupled;
  const std::set<std::string, std::less<>> known = coupled_joints(model);
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.mimic) return;
    (known.contains(joint.name.value_or("")) ? coupled : mimics).push_back(&joint);
  });
  const bool are_coupled = mimics.empty();
  mimics.insert(mimics.end(), coupled.begin(), coupled.end());
  if (mimics.empty()) return;
  Diagnostic& diagnostic = findings.report(tag_name(model, mimics.front()->mimic->element),
                                           title(*mimics.front()) + " mimics another joint");
  if (are_coupled) diagnostic.when(kCoupled);
  if (mimics.size() > 1) {
    diagnostic.note(counted(mimics.size() - 1, "more joint mimics another one",
                            "more joints mimic another one"));
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "follows the `mimic_motor` of the motor",
     "MARS smurf.cpp:902-910", when(kCoupled)},
    {&readers::mars,
     Effect::loses,
     "ignores `mimic` elements; it reads `mimic_motor` instead",
     "MARS smurf.cpp:902-910",
     {},
     "write `mimic_motor`, `mimic_multiplier` and `mimic_offset` in the motor of the joint"},
    {&readers::pybullet,
     Effect::loses,
     "ignores `mimic` elements: the joint moves independently",
     kRun,
     {},
     "couple the joints after loading, with `createConstraint` and JOINT_GEAR"},
    {&readers::gazebo, Effect::loses,
     "ignores `mimic` elements before sdformat 14, so the joint moves independently",
     "sdformat parser_urdf.cc:3152; 12.3, run", before({14, 0}),
     "use Gazebo Harmonic or a later one, which reads it, or command each joint"},
    {&readers::gazebo, Effect::takes, "reads `mimic` elements",
     "sdformat 14.0.0 parser_urdf.cc, read"},
    {&readers::mujoco, Effect::loses,
     "ignores `mimic` elements before 3.13, so the joint moves independently", "3.12.0, run",
     before({3, 13}),
     "use MuJoCo 3.13 or a later one, or export the robot: smurfs-flatten --format mjcf couples "
     "the joints"},
    {&readers::mujoco, Effect::takes, "reads `mimic` elements", kRun},
    {&readers::drake,
     Effect::changes,
     "couples the joints in some solvers only",
     "Drake detail_urdf_parser.cc:791-880",
     {},
     "use a discrete plant whose contact approximation is `sap`, `similar` or `lagged`"},
    {&readers::pinocchio,
     Effect::loses,
     "ignores `mimic` elements, unless it is called with `mimic=True`",
     kRun,
     {},
     "read the robot with `buildModelFromUrdf(file, mimic=True)`"},
};

}  // namespace

extern constinit const Rule sml1915_mimic_unread{
    .id = "SML1915",
    .name = "mimic-unread",
    .severity = Severity::warning,
    .summary = "A joint mimics another one, which a target ignores.",
    .why = "Fingers of a gripper move one by one.",
    .remedy = "Couple the joints in the way that the target knows.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1915_mimic_unread_file
