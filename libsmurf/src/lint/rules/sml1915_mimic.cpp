// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::vector<const urdf::Joint*> mimics;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.mimic) mimics.push_back(&joint);
  });
  if (mimics.empty()) return;
  Diagnostic& diagnostic = findings.report(tag_name(model, mimics.front()->mimic->element),
                                           title(*mimics.front()) + " mimics another joint");
  if (mimics.size() > 1) {
    diagnostic.notes.push_back("so do " + std::to_string(mimics.size() - 1) + " more joints");
  }
}

}  // namespace

extern constinit const Rule sml1915_mimic{
    .id = "SML1915",
    .name = "mimic",
    .severity = Severity::warning,
    .summary = "A joint mimics another one, which a target ignores.",
    .why = "Bullet has no code for mimic and MARS reads it from motors only: fingers of a gripper "
           "move one by one. sdformat writes it since version 14 only.",
    .remedy = "Couple the joints where the target can: `mimic_motor` of a motor for MARS, a gear "
              "constraint for Bullet.",
    .sources = "Bullet UrdfParser.cpp; MARS smurf.cpp:902-910, MotorManager.cpp:105-109; sdformat "
               "parser_urdf.cc:3152.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
