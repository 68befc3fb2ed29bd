// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1305_name_empty_file {
namespace {

constexpr Circumstance kMerged{"merged"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.name && link.name->empty()) {
      findings.report(tag_name(model, link.element), "a link has an empty name");
    }
  });
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.name && joint.name->empty()) {
      Diagnostic& diagnostic =
          findings.report(tag_name(model, joint.element), "a joint has an empty name");
      // sdformat has no link `world` into which it could merge another.
      const bool is_merged =
          joint.type == urdf::JointType::fixed && joint.parent.value_or("") != "world";
      if (is_merged) diagnostic.when(kMerged);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::loses, "leaves out the joint", kRun, at("joint")},
    {&readers::urdfdom, Effect::takes, "accepts a joint without a name", kRun, at("joint")},
    {&readers::urdfdom, Effect::refuses, "reports two roots and refuses the file", kRun},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::takes, "merges the two into one link without a joint", kRun,
     at("joint").when(kMerged)},
    {&readers::gazebo, Effect::refuses, "refuses a joint without a name", kRun, at("joint")},
    {&readers::mujoco, Effect::takes, "accepts a joint without a name", kRun, at("joint")},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1305_name_empty{.id = "SML1305",
                                               .name = "name-empty",
                                               .severity = Severity::error,
                                               .summary = "A link or joint has an empty name.",
                                               .why = "Nothing can refer to it.",
                                               .remedy = "Give it a name.",
                                               .check_model = check,
                                               .facts = kFacts};

}  // namespace smurf::rules::sml1305_name_empty_file
