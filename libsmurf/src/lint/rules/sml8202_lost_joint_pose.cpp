// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8202_lost_joint_pose_file {

extern constinit const Rule sml8202_lost_joint_pose{
    .id = "SML8202",
    .name = "lost-joint-pose",
    .severity = Severity::warning,
    .summary = "The joints of a model start at zero instead of in their named pose.",
    .why = "The format cannot store the initial position of a joint.",
    .remedy = "Choose a form or format that has it: SDF with --form expand, MJCF, Drake "
              "directives, JSON.",
    .sources = "SDFormat 1.9 joint.sdf; URDF has no such element.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8202_lost_joint_pose_file
