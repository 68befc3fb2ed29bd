// SPDX-License-Identifier: BSD-3-Clause
// Robots that are made from files of other languages.
#include "base/findings/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9301_mujoco_refuses{
    .id = "SML9301",
    .name = "mujoco-refuses",
    .severity = Severity::error,
    .summary = "MuJoCo refuses the MJCF file.",
    .why = "The model does not compile, so there is no robot.",
    .remedy = "Correct the value or the element, as the message says.",
    .sources = "MuJoCo 4.0.0, run; its schema by mj_printSchema().",
    .blocks_building = true};

extern constinit const Rule sml9302_mjcf_file_missing{
    .id = "SML9302",
    .name = "mjcf-file-missing",
    .severity = Severity::error,
    .summary = "A mesh that gives an MJCF body its mass cannot be read.",
    .why = "The model does not compile without the file. Here, the mass of the body stays unknown.",
    .remedy = "Correct the path of the file, or write the mass into `<inertial>`.",
    .sources = "MuJoCo 4.0.0, run."};

extern constinit const Rule sml9303_mjcf_limit{
    .id = "SML9303",
    .name = "mjcf-limit",
    .severity = Severity::error,
    .summary = "An MJCF model is larger than a limit.",
    .why = "Copies and included files can make a model of any size from a few lines.",
    .remedy = "Make the model smaller, or raise the limit.",
    .sources = "smurf-lint",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml9304_lost_in_urdf{
    .id = "SML9304",
    .name = "lost-in-urdf",
    .severity = Severity::warning,
    .summary = "A URDF cannot say what the MJCF says here.",
    .why =
        "The robot that is made from the file lacks this part: closed loops, tendons, soft bodies, limits of ball joints and some shapes have no form in a URDF.",
    .remedy = "Keep the MJCF for simulators that need the part, or describe it in another way.",
    .sources = "The elements of URDF; MuJoCo 4.0.0, run."};

extern constinit const Rule sml9305_range_without_limit{
    .id = "SML9305",
    .name = "range-without-limit",
    .severity = Severity::warning,
    .summary = "A range of an MJCF file begins above its end, so it is no limit.",
    .why =
        "A range limits a joint only if its first number is smaller, and nothing tells of another one.",
    .remedy = "Write the smaller number first.",
    .sources = "MuJoCo 4.0.0, run."};

extern constinit const Rule sml9306_ignored_by_mujoco{
    .id = "SML9306",
    .name = "ignored-by-mujoco",
    .severity = Severity::warning,
    .summary = "MuJoCo ignores an attribute of an MJCF file without telling.",
    .why = "Inside of `<frame>` and `<replicate>`, attributes are not compared with those that are "
           "known, so a misspelt one has no effect.",
    .remedy = "Correct the name of the attribute, or delete it.",
    .sources = "MuJoCo 4.0.0, run."};

extern constinit const Rule sml9307_class_without_use{
    .id = "SML9307",
    .name = "class-without-use",
    .severity = Severity::info,
    .summary = "Nothing uses a class of defaults of an MJCF file.",
    .why = "Its values have no effect. Often the class of an element is misspelt or was forgotten.",
    .remedy = "Name the class at the elements that it is meant for, or delete it.",
    .sources = "The file alone."};

}  // namespace smurf::rules
