// SPDX-License-Identifier: BSD-3-Clause
// Newton. Its importer parses URDF with ElementTree of Python, which refuses malformed XML, and
// reads numbers with float(). Its builder checks little: it keeps numbers that make no sense, and
// uses its own defaults where a number is absent.
#include <algorithm>
#include <optional>
#include <vector>

#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::readers::newton_file {
namespace {

using namespace rules;
using enum Effect;

constexpr std::string_view kKeeps = "keeps the number";
constexpr std::string_view kIgnores = "does not look at it";
constexpr std::string_view kDefault = "takes its own default";
constexpr std::string_view kRefusesNumber = "refuses the number, and the file";
constexpr std::string_view kRefusesMesh = "refuses the file: it cannot load the mesh";
constexpr std::string_view kNotXml = "refuses what is no well-formed XML";

constexpr FamilyFact kFamilies[] = {
    // XML
    {sml0003_invalid_utf8,
     {&newton, takes, "reads the encoding that the declaration names", kRun,
      when(cases::kOtherEncoding)}},
    {sml0003_invalid_utf8, {&newton, refuses, kNotXml, kRun}},
    {sml0004_control_character, {&newton, refuses, kNotXml, kRun}},
    {sml0005_unsupported_encoding, {&newton, takes, "reads UTF-16", kRun}},
    {sml1001_xml_malformed, {&newton, refuses, kNotXml, kRun}},
    {sml1002_xml_undeclared_prefix,
     {&newton, refuses, "refuses a prefix that is not declared", kRun}},
    {sml1003_xml_bare_ampersand, {&newton, refuses, kNotXml, kRun}},
    {sml1004_xml_comment_dashes, {&newton, refuses, kNotXml, kRun}},
    {sml1005_xml_junk_before_prolog, {&newton, refuses, kNotXml, kRun}},
    {sml1006_xml_several_roots, {&newton, refuses, kNotXml, kRun}},
    {sml1008_xml_encoding,
     {&newton, refuses, "refuses bytes that are not of the encoding that the declaration names",
      kRun}},
    {sml1009_xacro_residue, {&newton, changes, "uses the text literally", kRun, at("@name")}},
    {sml1009_xacro_residue, {&newton, changes, "uses the text literally", kRun, at("@joint")}},
    {sml1009_xacro_residue,
     {&newton, refuses, "refuses a URI that is not absolute", kRun,
      at("@filename").when(cases::kUnexpandedUri)}},
    {sml1009_xacro_residue, newton_without_mesh(at("mesh/@filename"))},
    {sml1009_xacro_residue,
     {&newton, loses, "leaves the texture out", kRun, at("texture/@filename")}},
    {sml1009_xacro_residue,
     {&newton, loses, "ignores the element: everything it would expand to is missing", kRun,
      at("xacro:")}},
    {sml1009_xacro_residue,
     {&newton, refuses, "refuses the text, which is no number and no name of a link", kRun}},
    {sml1012_percent_in_value, {&newton, takes, "keeps the name", kRun, at("@name")}},
    {sml1012_percent_in_value, {&newton, refuses, kRefusesNumber, kRun}},
    {sml1013_dtd_or_xinclude,
     {&newton, takes, "skips the document type", kRun, when(cases::kDeclarations)}},
    {sml1013_dtd_or_xinclude, {&newton, refuses, "refuses an entity that it does not know", kRun}},
    {sml1014_xml_missing_blank, {&newton, refuses, kNotXml, kRun}},
    {sml1015_xml_late_instruction,
     {&newton, refuses, kNotXml, kRun, when(cases::kLateDeclaration)}},
    {sml1015_xml_late_instruction, {&newton, takes, "skips the instruction", kRun}},
    {sml1017_xml_less_than_in_value, {&newton, refuses, kNotXml, kRun}},
    // Elements and attributes
    {sml1101_root_not_robot, {&newton, refuses, "finds no link in it", kRun, when(cases::kSdf)}},
    {sml1101_root_not_robot, {&newton, refuses, "finds no link in it", kRun, when(cases::kMjcf)}},
    {sml1101_root_not_robot,
     {&newton, refuses, "finds no link in it", kRun, when(cases::kWithoutLinks)}},
    {sml1101_root_not_robot, {&newton, takes, "does not look at the name of the root", kRun}},
    {sml1102_robot_name_missing, {&newton, takes, "takes a robot without a name", kRun}},
    {sml1110_geometry_missing, {&newton, loses, "builds the link without the shape", kRun}},
    {sml1111_geometry_several_shapes, {&newton, changes, "builds all of the shapes", kRun}},
    {sml1112_geometry_first_child_foreign, {&newton, takes, "skips other elements", kRun}},
    {sml1113_required_attribute_missing,
     {&newton, loses, "builds the link without the shape", kRun, at("mesh")}},
    {sml1113_required_attribute_missing,
     {&newton, refuses, "finds no link of the name that a joint uses", kRun,
      when(cases::kLinkTag, kMissed)}},
    {sml1113_required_attribute_missing,
     {&newton, loses, "leaves out the link", kRun, when(cases::kLinkTag)}},
    {sml1113_required_attribute_missing,
     {&newton, loses, "reads no such material", kRun, at("material")}},
    {sml1113_required_attribute_missing,
     {&newton, loses, "warns, and lets the joint move independently", kRun, at("mimic")}},
    {sml1113_required_attribute_missing, {&newton, changes, kDefault, kRun}},
    {sml1114_tag_case,
     {&newton, refuses, "ignores the joint, and does not find its child at the joints behind it",
      kRun, when(cases::kChainTag)}},
    {sml1114_tag_case,
     {&newton, loses, "ignores the joint, and drops its child", kRun, when(cases::kJointTag)}},
    // Trees
    {sml1201_unknown_link_of_joint,
     {&newton, loses, "leaves out what no root reaches", kRun, when(kUnreached)}},
    {sml1206_link_with_two_parents,
     {&newton, refuses, "refuses the file: it sorts no links with two parents", kRun}},
    {sml1212_floating_not_at_root, {&newton, takes, "makes a free joint", kRun}},
    {sml1213_floating_or_planar,
     {&newton, changes, "makes a joint that slides along two axes and does not turn", kRun,
      when(kInPlanar)}},
    {sml1213_floating_or_planar, {&newton, takes, "makes a free joint", kRun}},
    // Names
    {sml1301_duplicate_name, {&newton, changes, "keeps both joints", kRun, at("joint")}},
    {sml1301_duplicate_name, {&newton, loses, "builds the first link of that name", kRun}},
    {sml1305_name_empty, {&newton, takes, "keeps the empty name", kRun, at("joint")}},
    {sml1305_name_empty,
     {&newton, loses, "finds no joint that connects the link, and drops it", kRun}},
    {sml1306_reference_whitespace,
     {&newton, takes, "keeps the name with the space", kRun, at("joint/@name")}},
    // Joints
    {sml1401_type_missing_or_unknown,
     {&newton, loses, "leaves out what no root reaches", kRun, when(kUnreached)}},
    {sml1403_limit_missing, {&newton, changes, "sets no limits: 1e10 both ways", kRun}},
    {sml1404_limit_incomplete, {&newton, changes, "sets the limit to 1e6", kRun}},
    {sml1406_bound_missing, {&newton, changes, "sets no limit on that side: 1e10", kRun}},
    {sml1407_limits_swapped, {&newton, changes, "keeps the swapped limits", kRun}},
    {sml1408_bounds_equal, {&newton, takes, "locks the joint", kRun}},
    {sml1409_continuous_with_bounds,
     {&newton, changes, "applies the limits to the continuous joint", kRun}},
    {sml1414_limit_zero, {&newton, changes, kKeeps, kRun}},
    {sml1415_limit_negative, {&newton, changes, kKeeps, kRun}},
    {sml1421_axis_zero, {&newton, changes, "keeps an axis without direction", kRun}},
    {sml1422_axis_not_unit, {&newton, takes, "normalises the axis", kRun}},
    {sml1425_dynamics_empty, {&newton, changes, "sets damping and friction to 0", kRun}},
    {sml1426_dynamics_negative, {&newton, changes, kKeeps, kRun}},
    {sml1432_mimic_target_unknown,
     {&newton, loses, "warns, and lets the joint move independently", kRun}},
    {sml1433_mimic_self_or_cycle, {&newton, refuses, "refuses joints that mimic each other", kRun}},
    {sml1437_mimic_type,
     {&newton, refuses, "refuses a follower or a leader that does not move about or along one axis",
      kRun}},
    // Inertials
    {sml1501_moving_link_without_inertial,
     {&newton, changes, "gives it the mass of its collisions at 1000 kg/m3", kRun}},
    {sml1502_no_inertial_anywhere,
     {&newton, changes, "gives the links the masses of their collisions at 1000 kg/m3", kRun}},
    {sml1504_mass_missing,
     {&newton, changes, "takes the mass of the collisions at 1000 kg/m3", kRun}},
    {sml1505_inertia_missing,
     {&newton, changes, "takes the inertia of the collisions at 1000 kg/m3", kRun}},
    {sml1506_inertia_attribute_missing, {&newton, changes, "reads 0", kRun}},
    {sml1508_mass_zero, {&newton, changes, "keeps 0: forces do not move the body", kRun}},
    {sml1509_mass_negative,
     {&newton, changes, "keeps the number, and sets it to 0 when the model is finished", kRun}},
    {sml1511_inertia_all_zero, {&newton, changes, "keeps 0: torques do not turn the body", kRun}},
    {sml1512_not_positive_definite,
     {&newton, changes, "keeps the moments, and enlarges them when the model is finished", kRun}},
    {sml1513_triangle_violated,
     {&newton, changes, "keeps the moments, and enlarges them when the model is finished", kRun}},
    {sml1916_link_without_inertial,
     {&newton, changes, "gives it the mass of its collisions at 1000 kg/m3", kRun}},
    // Shapes
    {sml1601_size_not_positive, {&newton, changes, "keeps a shape without volume", kRun}},
    {sml1602_shape_nonstandard,
     {&newton, changes, "reads `height` in place of `length`, or takes 1 m", kRun, at("capsule")}},
    {sml1602_shape_nonstandard, {&newton, loses, "builds the link without the shape", kRun}},
    {sml1605_mesh_case, newton_without_mesh()},
    {sml1606_mesh_backslash, newton_without_mesh()},
    {sml1607_mesh_absolute,
     {&newton, loses, "where the file is missing, builds the link without the shape", kRun}},
    {sml1609_mesh_package_malformed, {&newton, refuses, kRefusesMesh, kRun}},
    {sml1627_scale_zero, {&newton, changes, "keeps a shape without volume", kRun}},
    {sml1628_scale_negative, {&newton, changes, "mirrors the mesh", kRun}},
    {sml1643_mesh_lfs_pointer, {&newton, refuses, kRefusesMesh, kRun}},
    {sml1644_mesh_broken, {&newton, refuses, kRefusesMesh, kRun}},
    {sml1645_mesh_format_mismatch, {&newton, refuses, kRefusesMesh, kRun}},
    {sml1704_material_duplicate_global, {&newton, takes, "uses the last", kRun}},
    {sml1707_rgba_range,
     {&newton, takes, "brings the opacity between 0 and 1, and keeps the colours", kRun}},
    // Numbers
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("limit")}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("mass")}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("inertia")}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("dynamics")}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, at("axis")}},
    {sml1801_not_a_number, {&newton, takes, "takes white", kRun, at("@rgba").when(cases::kBlanks)}},
    {sml1801_not_a_number, {&newton, refuses, kRefusesNumber, kRun, when(cases::kBlanks)}},
    {sml1801_not_a_number, {&newton, changes, kDefault, kRun, when(cases::kEmpty)}},
    {sml1802_number_whitespace, {&newton, takes, "skips white space", kRun}},
    {sml1803_number_nan, {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {sml1803_number_nan,
     {&newton, changes, "keeps it, and computes with it until nothing has a position", kRun}},
    {sml1804_number_infinite, {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {sml1804_number_infinite, {&newton, changes, "keeps infinity", kRun}},
    {sml1807_vector_count,
     {&newton, takes, "uses the first three numbers", kRun, at("axis").when(cases::kTooMany)}},
    {sml1807_vector_count,
     {&newton, takes, "uses the first three numbers", kRun, at("box").when(cases::kTooMany)}},
    {sml1807_vector_count,
     {&newton, changes, "leaves the colour at its default", kRun, at("@rgba")}},
    {sml1810_overflow_underflow, {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {sml1810_overflow_underflow, {&newton, changes, "reads infinity or 0", kRun}},
    {sml1811_unicode_digit_or_space, {&newton, refuses, kRefusesNumber, kRun, at("@rgba")}},
    {sml1811_unicode_digit_or_space, {&newton, takes, "reads the digits of other scripts", kRun}},
    {"SML18", {&newton, refuses, kRefusesNumber, kRun}},
};

constexpr Fact kUnread[] = {
    {&newton, ignores, kIgnores, kRun, at("robot/@version")},
    {&newton, ignores, kIgnores, kRun, at("calibration")},
    {&newton, ignores, kIgnores, kRun, at("safety_controller")},
    {&newton, ignores, kIgnores, kRun, at("transmission")},
    {&newton, ignores, kIgnores, kRun, at("gazebo")},
};

/// Whether no root reaches the child of a joint: it is part of a ring, or follows one. A joint
/// whose parent and child are one absent link is such a ring.
bool is_unreached(const LinkedModel& model, std::size_t joint, const std::vector<bool>& reached) {
  const std::optional<LinkIndex> child = model.tree.joint_child[joint];
  if (child) return !reached[to_size(*child)];
  const urdf::Joint& one = model.robot->joints[joint];
  return one.parent && one.child && *one.parent == *one.child;
}

bool is_missed(const LinkedModel& model) {
  const std::vector<std::optional<LinkIndex>>& parents = model.tree.joint_parent;
  const std::vector<std::optional<LinkIndex>>& children = model.tree.joint_child;
  return std::find(parents.begin(), parents.end(), std::nullopt) != parents.end() ||
         std::find(children.begin(), children.end(), std::nullopt) != children.end();
}

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  std::vector<bool> reached;  // computed when it is needed
  const bool is_link_missed = is_missed(model);
  for (Diagnostic* finding : found) {
    if (is_link_missed) finding->when(kMissed);
    const urdf::Joint* joint = part_at(model.robot->joints, finding->span.begin);
    if (joint == nullptr) continue;
    if (reached.empty()) reached = reached_links(model);
    if (is_unreached(model, index_in(model.robot->joints, *joint), reached)) {
      finding->when(kUnreached);
    }
  }
}

}  // namespace

extern constinit const Reader newton{.name = "newton",
                                     .title = "Newton",
                                     .basis = "1.8.0 (wheel `newton[importers]`), executed: "
                                              "ModelBuilder.add_urdf with its own settings",
                                     .like = &urdf,
                                     .version = "Newton 1.8",
                                     .families = kFamilies,
                                     .unread = kUnread,
                                     .see = see};

}  // namespace smurf::readers::newton_file
