// SPDX-License-Identifier: BSD-3-Clause
// Isaac Sim and Isaac Lab, by their converter from URDF to USD, which was run. It parses URDF with
// ElementTree of Python, and reads numbers with float().
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::readers::isaac_file {
namespace {

using namespace rules;
using enum Effect;

constexpr std::string_view kKeeps = "keeps the number";
constexpr std::string_view kDefault = "takes its own default";
constexpr std::string_view kRefusesNumber = "refuses the number, and the file";
constexpr std::string_view kNotXml = "refuses what is no well-formed XML";
constexpr std::string_view kCustom = "keeps it as a custom prim or attribute that nothing uses";

constexpr FamilyFact kFamilies[] = {
    // XML
    {sml0003_invalid_utf8, {&isaac, refuses, kNotXml, kRun}},
    {sml0004_control_character, {&isaac, refuses, kNotXml, kRun}},
    {sml0005_unsupported_encoding, {&isaac, refuses, kNotXml, kRun}},
    {sml1001_xml_malformed, {&isaac, refuses, kNotXml, kRun}},
    {sml1002_xml_undeclared_prefix,
     {&isaac, refuses, "refuses a prefix that is not declared", kRun}},
    {sml1003_xml_bare_ampersand, {&isaac, refuses, kNotXml, kRun}},
    {sml1004_xml_comment_dashes, {&isaac, refuses, kNotXml, kRun}},
    {sml1005_xml_junk_before_prolog,
     {&isaac, takes, "skips the blanks", kRun, when(cases::kBlanks)}},
    {sml1005_xml_junk_before_prolog, {&isaac, refuses, kNotXml, kRun}},
    {sml1006_xml_several_roots, {&isaac, refuses, kNotXml, kRun}},
    {sml1008_xml_encoding, {&isaac, takes, "reads UTF-8, whatever the declaration says", kRun}},
    {sml1009_xacro_residue, {&isaac, changes, "uses the text literally", kRun, at("@name")}},
    {sml1009_xacro_residue, isaac_without_mesh(at("mesh/@filename"))},
    {sml1009_xacro_residue,
     {&isaac, loses, "leaves the texture out", kRun, at("texture/@filename")}},
    {sml1009_xacro_residue,
     {&isaac, loses, "ignores the element: everything it would expand to is missing", kRun,
      at("xacro:")}},
    {sml1009_xacro_residue,
     {&isaac, refuses, "refuses the text, which is no number and no name of a link", kRun}},
    {sml1012_percent_in_value, {&isaac, takes, "keeps the name", kRun, at("@name")}},
    {sml1012_percent_in_value, {&isaac, refuses, kRefusesNumber, kRun}},
    {sml1013_dtd_or_xinclude,
     {&isaac, takes, "skips the document type", kRun, when(cases::kDeclarations)}},
    {sml1013_dtd_or_xinclude, {&isaac, refuses, "refuses an entity that it does not know", kRun}},
    {sml1014_xml_missing_blank, {&isaac, refuses, kNotXml, kRun}},
    {sml1015_xml_late_instruction, {&isaac, takes, "skips the instruction", kRun}},
    {sml1017_xml_less_than_in_value, {&isaac, refuses, kNotXml, kRun}},
    // Elements and attributes
    {sml1101_root_not_robot, {&isaac, refuses, "refuses a root that is not `robot`", kRun}},
    {sml1102_robot_name_missing, {&isaac, refuses, "refuses a robot without a name", kRun}},
    {sml1108_misplaced_element, {&isaac, loses, kCustom, kRun}},
    {sml1109_duplicate_singleton, {&isaac, changes, "uses the last one", kRun}},
    {sml1110_geometry_missing, isaac_without_mesh()},
    {sml1111_geometry_several_shapes, {&isaac, changes, "uses the last shape", kRun}},
    {sml1112_geometry_first_child_foreign, {&isaac, takes, "skips other elements", kRun}},
    {sml1113_required_attribute_missing,
     {&isaac, changes, kDefault, kRun, at("safety_controller")}},
    {sml1113_required_attribute_missing, {&isaac, changes, kDefault, kRun, at("axis")}},
    {sml1113_required_attribute_missing, {&isaac, changes, kDefault, kRun, at("box")}},
    {sml1113_required_attribute_missing, {&isaac, changes, kDefault, kRun, at("color")}},
    {sml1113_required_attribute_missing, {&isaac, changes, kDefault, kRun, at("mass")}},
    {sml1113_required_attribute_missing,
     {&isaac, refuses, "refuses a material without a name", kRun, at("robot/material")}},
    {sml1113_required_attribute_missing,
     {&isaac, changes, "gives it a name of its own", kRun, at("material")}},
    {sml1113_required_attribute_missing, isaac_without_mesh(at("mesh"))},
    {sml1113_required_attribute_missing, {&isaac, refuses, "refuses the file", kRun}},
    {sml1114_tag_case,
     {&isaac, loses, "ignores the joint, and drops what is behind it", kRun,
      when(cases::kJointTag)}},
    // Trees
    {sml1115_no_links, {&isaac, refuses, "refuses a robot without links", kRun}},
    {sml1204_several_roots, {&isaac, loses, "converts what is below the first root only", kRun}},
    {sml1206_link_with_two_parents,
     {&isaac, changes, "builds the link below each of its parents", kRun}},
    {sml1212_floating_not_at_root,
     {&isaac, changes, "makes no joint, so that the link floats", kRun}},
    {sml1213_floating_or_planar,
     {&isaac, changes, "makes a joint of its own", kRun, when(kInPlanar)}},
    {sml1213_floating_or_planar, {&isaac, takes, "makes no joint, so that the link floats", kRun}},
    // Names
    {sml1301_duplicate_name, {&isaac, refuses, "refuses two of one name", kRun}},
    {sml1305_name_empty, {&isaac, refuses, "refuses an element without a name", kRun}},
    {sml1306_reference_whitespace,
     {&isaac, takes, "keeps the name with the space", kRun, at("joint/@name")}},
    // Joints
    {sml1403_limit_missing, {&isaac, changes, "sets no limits", kRun}},
    {sml1404_limit_incomplete,
     {&isaac, changes, "writes no such limit; that of the effort is a custom attribute", kRun}},
    {sml1406_bound_missing, {&isaac, changes, "takes 0 for it", kRun}},
    {sml1407_limits_swapped, {&isaac, changes, "keeps the swapped limits", kRun}},
    {sml1408_bounds_equal, {&isaac, takes, "locks the joint", kRun}},
    {sml1409_continuous_with_bounds, {&isaac, ignores, "writes no limits", kRun}},
    {sml1414_limit_zero, {&isaac, changes, kKeeps, kRun}},
    {sml1415_limit_negative, {&isaac, changes, kKeeps, kRun}},
    {sml1422_axis_not_unit, {&isaac, takes, "normalises the axis", kRun}},
    {sml1425_dynamics_empty, {&isaac, changes, kDefault, kRun}},
    {sml1426_dynamics_negative, {&isaac, changes, kKeeps, kRun}},
    {sml1432_mimic_target_unknown,
     {&isaac, refuses, "refuses a joint that mimics an unknown one", kRun}},
    {sml1433_mimic_self_or_cycle,
     {&isaac, changes, "writes the joints that follow each other", kRun}},
    // Inertials
    {sml1501_moving_link_without_inertial,
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    {sml1502_no_inertial_anywhere,
     {&isaac, changes, "writes no masses: the simulator computes them from the collisions", kRun}},
    {sml1504_mass_missing,
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    {sml1505_inertia_missing,
     {&isaac, changes, "writes no inertia: the simulator computes it from the collisions", kRun}},
    {sml1506_inertia_attribute_missing, {&isaac, changes, "reads 0", kRun}},
    {sml1508_mass_zero,
     {&isaac, changes, "writes 0, in place of which the simulator computes it", kRun}},
    {sml1509_mass_negative, {&isaac, changes, kKeeps, kRun}},
    {sml1511_inertia_all_zero,
     {&isaac, changes, "writes 0, in place of which the simulator computes it", kRun}},
    {sml1512_not_positive_definite, {&isaac, changes, kKeeps, kRun}},
    {sml1513_triangle_violated, {&isaac, changes, kKeeps, kRun}},
    {sml1916_link_without_inertial,
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    // Shapes
    {sml1601_size_not_positive, {&isaac, changes, "keeps a shape without volume", kRun}},
    {sml1602_shape_nonstandard, isaac_without_mesh()},
    {sml1605_mesh_case, isaac_without_mesh()},
    {sml1606_mesh_backslash, isaac_without_mesh()},
    {sml1607_mesh_absolute,
     {&isaac, loses, "where the file is missing, builds the link without the shape", kRun}},
    {sml1627_scale_zero, {&isaac, changes, "keeps a shape without volume", kRun}},
    {sml1628_scale_negative, {&isaac, changes, "mirrors the mesh", kRun}},
    {sml1643_mesh_lfs_pointer, isaac_without_mesh()},
    {sml1644_mesh_broken, isaac_without_mesh()},
    {sml1645_mesh_format_mismatch, isaac_without_mesh()},
    {sml1651_package_unknown, isaac_without_mesh(at("mesh"))},
    {sml1704_material_duplicate_global,
     {&isaac, refuses, "refuses two materials of one name", kRun}},
    {sml1707_rgba_range, {&isaac, takes, kKeeps, kRun}},
    // Numbers
    {sml1802_number_whitespace, {&isaac, takes, "skips white space", kRun}},
    {sml1803_number_nan,
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun, at("inertia")}},
    {sml1803_number_nan,
     {&isaac, changes, "keeps it, and computes with it until nothing has a position", kRun}},
    {sml1804_number_infinite,
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun, at("inertia")}},
    {sml1804_number_infinite, {&isaac, changes, "keeps infinity", kRun}},
    {sml1810_overflow_underflow,
     {&isaac, takes, "reads the number", kRun, when(cases::kSubnormal)}},
    {sml1810_overflow_underflow,
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun,
      at("inertia").unless(cases::kUnderflow)}},
    {sml1810_overflow_underflow, {&isaac, changes, "reads infinity or 0", kRun}},
    {sml1811_unicode_digit_or_space, {&isaac, takes, "reads the digits of other scripts", kRun}},
    {"SML18", {&isaac, refuses, kRefusesNumber, kRun}},
};

constexpr Fact kUnread[] = {
    {&isaac, ignores, "does not look at it", kRun, at("robot/@version").unless(kPrefixed)},
    {&isaac, ignores, kCustom, kRun, at("transmission").unless(kPrefixed)},
    {&isaac, ignores, kCustom, kRun, at("gazebo").unless(kPrefixed)},
};

// The importer of Isaac Sim 6 is urdf-usd-converter; before, it was one in C++.
constexpr ReaderVersion kIn5[] = {{&isaac, {5, 0}}};
constexpr ReaderVersion kIn6[] = {{&isaac, {6, 0}}};
constexpr Reader kIsaac5{.name = "isaac:5",
                         .title = "Isaac Sim 5",
                         .basis = "its importer was not run; names from PathUtils.cpp",
                         .like = &isaac,
                         .parts = kIn5};
constexpr Reader kIsaac6{.name = "isaac:6",
                         .title = "Isaac Sim 6",
                         .basis = "urdf-usd-converter 0.3.4, executed",
                         .like = &isaac,
                         .parts = kIn6};
constexpr const Reader* kEarlier[] = {&kIsaac5};
constexpr const Reader* kReleases[] = {&kIsaac6};

}  // namespace

extern constinit const Reader isaac{
    .name = "isaac",
    .title = "Isaac",
    .basis = "urdf-usd-converter 0.3.4 (wheel), executed: what it writes into the USD. "
             "Isaac Sim itself needs a graphics card and was not run",
    .like = &urdf,
    .version = "urdf-usd-converter 0.3.4",
    .families = kFamilies,
    .unread = kUnread,
    .number = {6, 0},
    .releases = kReleases,
    .earlier = kEarlier};

}  // namespace smurf::readers::isaac_file
