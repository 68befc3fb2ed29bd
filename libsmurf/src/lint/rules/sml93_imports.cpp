// SPDX-License-Identifier: BSD-3-Clause
// Robots that are made from files of other languages.
#include <string_view>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kRan = "MuJoCo 4.0.0, run";

constexpr Fact kMujocoRefuses[] = {
    {&readers::mujoco, Effect::refuses, "does not compile the model", kRan}};
constexpr Fact kMujocoNeedsMesh[] = {
    {&readers::mujoco, Effect::takes, "makes the mesh itself", kRan, when(cases::kMadeByMujoco)},
    {&readers::mujoco, Effect::refuses, "does not compile the model", kRan}};
constexpr Fact kSdformatRefuses[] = {
    {&readers::gazebo, Effect::refuses, "refuses the file", "libsdformat 12, run"}};

}  // namespace

extern constinit const Rule sml9301_mujoco_refuses{
    .id = "SML9301",
    .name = "mujoco-refuses",
    .severity = Severity::error,
    .summary = "MuJoCo refuses the MJCF file.",
    .why = "The model does not compile, so there is no robot.",
    .remedy = "Correct the value or the element, as the message says.",
    .sources = "MuJoCo 4.0.0, run; its schema by mj_printSchema().",
    .facts = kMujocoRefuses,
    .blocks_building = true};

extern constinit const Rule sml9302_mjcf_file_missing{
    .id = "SML9302",
    .name = "mjcf-file-missing",
    .severity = Severity::error,
    .summary = "A mesh that gives an MJCF body its mass cannot be read.",
    .why = "The model does not compile without the file. Here, the mass of the body stays unknown.",
    .remedy = "Correct the path of the file, or write the mass into `<inertial>`.",
    .sources = "MuJoCo 4.0.0, run.",
    .facts = kMujocoNeedsMesh};

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
    .summary = "A URDF cannot say what an MJCF or SDF file says here.",
    .why =
        "The robot that is made from the file lacks this part: closed loops, tendons, soft bodies, limits of ball joints, lights and some shapes have no form in a URDF.",
    .remedy = "Keep the file for simulators that need the part, or describe it in another way.",
    .sources = "The elements of URDF; MuJoCo 4.0.0 and libsdformat 12, run."};

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

extern constinit const Rule sml9308_default_holds_base{
    .id = "SML9308",
    .name = "default-holds-base",
    .severity = Severity::warning,
    .summary = "A default for the joints of an MJCF file acts on the free joint of the base, too.",
    .why =
        "`<joint type=\"free\">` takes damping, friction, armature and stiffness of its class, so the "
        "base is slowed down, and harder to move than its mass says. `<freejoint>` takes none.",
    .remedy = "Write `<freejoint/>`.",
    .sources = "MuJoCo 4.0.0, run.",
    .about = About::robot};

extern constinit const Rule sml9309_angle_unit{
    .id = "SML9309",
    .name = "angle-unit",
    .severity = Severity::warning,
    .summary = "Ranges of an MJCF file look as if they were in the other unit of angles.",
    .why =
        "Angles are degrees unless `<compiler>` says otherwise, and a joint of +-1.57 degrees hardly "
        "moves.",
    .remedy = "Write `<compiler angle=\"radian\"/>`, or correct the ranges.",
    .sources =
        "The file alone: most ranges are parts of pi, or, for radians, round numbers of degrees.",
    .about = About::robot};

extern constinit const Rule sml9310_contact_bits_without_partner{
    .id = "SML9310",
    .name = "contact-bits-without-partner",
    .severity = Severity::warning,
    .summary = "Shapes of an MJCF file have contact bits, and can touch nothing.",
    .why = "Two shapes touch if `contype` of one and `conaffinity` of the other share a bit. These "
           "meet no shape of another body, and no floor with the usual bits.",
    .remedy = "Give both shapes a common bit, or 0 and 0 to one that is only seen.",
    .sources = "MuJoCo 4.0.0, run.",
    .about = About::robot};

extern constinit const Rule sml9311_sdformat_refuses{
    .id = "SML9311",
    .name = "sdformat-refuses",
    .severity = Severity::error,
    .summary = "libsdformat refuses the SDF file.",
    .why = "It reports an error, and simulators that are built on it load no file with an error.",
    .remedy = "Correct the value or the element, as the message says.",
    .sources = "libsdformat 12, run; the descriptions of SDF 1.9.",
    .facts = kSdformatRefuses,
    .blocks_building = true};

extern constinit const Rule sml9312_sdf_file_missing{
    .id = "SML9312",
    .name = "sdf-file-missing",
    .severity = Severity::error,
    .summary = "A model that an SDF file includes cannot be read.",
    .why =
        "libsdformat reports an error for an include that it does not find. Here, the robot lacks "
        "the model.",
    .remedy = "Put the folder of the model beside that of the file, or correct the address.",
    .sources = "libsdformat 12, run."};

extern constinit const Rule sml9313_sdf_limit{
    .id = "SML9313",
    .name = "sdf-limit",
    .severity = Severity::error,
    .summary = "An SDF model is larger than a limit.",
    .why = "Included files can make a model of any size from a few lines.",
    .remedy = "Make the model smaller, or raise the limit.",
    .sources = "smurf-lint",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml9314_ignored_by_sdformat{
    .id = "SML9314",
    .name = "ignored-by-sdformat",
    .severity = Severity::warning,
    .summary = "libsdformat ignores a part of an SDF file.",
    .why =
        "An element or attribute of another name or of another version of SDF, a second one where "
        "there can be one, the name of a frame that is not there, and what follows a comma in a "
        "number have no effect, and nothing tells of it.",
    .remedy = "Correct the name or the number, or delete the part.",
    .sources = "libsdformat 12, run."};

extern constinit const Rule sml9315_mass_by_default{
    .id = "SML9315",
    .name = "mass-by-default",
    .severity = Severity::warning,
    .summary = "A link of an SDF file weighs 1 kg because nothing else is written.",
    .why = "In SDF, a link without a mass weighs 1 kg, and without `<inertia>` its moments are "
           "1 kg m^2, which few parts of a robot have. In a URDF it has no mass.",
    .remedy = "Write `<inertial>` with the mass and the inertia of the link.",
    .sources = "libsdformat 12, run."};

extern constinit const Rule sml9320_visual_shapes_weigh{
    .id = "SML9320",
    .name = "visual-shapes-weigh",
    .severity = Severity::warning,
    .summary = "Shapes of an MJCF file that are only seen add to the mass of their bodies.",
    .why = "A body without `<inertial>` weighs all its shapes, and each has the density of water "
           "unless it says otherwise. A mesh for the eye and a shape for contacts count twice.",
    .remedy = "Write `mass=\"0\"` in the class of shapes that are only seen, or `<inertial>`.",
    .sources = "MuJoCo 4.0.0, run.",
    .about = About::robot};

}  // namespace smurf::rules
