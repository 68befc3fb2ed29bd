// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.mimic || !joint.mimic->joint) return;
    check_reference(model, NameKind::joint, *joint.mimic->joint, joint.mimic->joint.span,
                    ("the mimic of " + title(joint)).c_str(), findings);
  });
}

}  // namespace

extern constinit const Rule sml1432_mimic_target_unknown{
    .id = "SML1432",
    .name = "mimic-target-unknown",
    .severity = Severity::error,
    .summary = "A joint mimics a joint that the robot does not have.",
    .why = "urdfdom, sdformat and MuJoCo leave the joint silently free, Drake refuses the file, "
           "urdf-loader crashes.",
    .remedy = "Correct the name.",
    .sources = "urdfdom 3.0.1, MuJoCo 3.14 and urdf-loader 0.13, executed.",
    .check_model = check};

}  // namespace smurf::rules
