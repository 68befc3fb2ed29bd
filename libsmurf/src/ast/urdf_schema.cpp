// SPDX-License-Identifier: BSD-3-Clause
// Sources: urdfdom 3.0.1 and 5.x parsers, the URDF XML specification on the ROS wiki; extensions as
// read by sdformat, Drake, Bullet, MuJoCo, Pinocchio and Isaac.
#include "ast/urdf_schema.hpp"

#include <algorithm>
#include <utility>

#include "base/suggest.hpp"
#include "base/words.hpp"

namespace smurf::urdf {
namespace {

constexpr AttributeSpec kRobotAttributes[] = {{"name"}, {"version"}};
constexpr ChildSpec kRobotChildren[] = {{"link"}, {"joint"}, {"material"}};
constexpr std::string_view kRobotExtensions[] = {"transmission",
                                                 "gazebo",
                                                 "sensor",
                                                 "ros2_control",
                                                 "mujoco",
                                                 "frame",
                                                 "loop_joint",
                                                 "loop",
                                                 "deformable",
                                                 "reduced_deformable",
                                                 "controller",
                                                 "group",
                                                 "disable_collisions",
                                                 "group_state",
                                                 "end_effector",
                                                 "virtual_joint",
                                                 "passive_joint",
                                                 "origin",
                                                 "static",
                                                 "export",
                                                 "plugin",
                                                 "author",
                                                 "submodel"};

constexpr AttributeSpec kLinkAttributes[] = {{"name", true}, {"type"}};
constexpr ChildSpec kLinkChildren[] = {{"inertial", true}, {"visual"}, {"collision"}};
constexpr std::string_view kLinkExtensions[] = {
    "contact",     "collision_checking", "audio_source", "self_collision_checking",
    "sensor",      "velocity_decay",     "kinematic",    "selfCollide",
    "gravity",     "inertia_from_file",  "bullet",       "self_filter",
    "drake_ignore"};

constexpr ChildSpec kInertialChildren[] = {{"origin", true}, {"mass", true}, {"inertia", true}};
constexpr AttributeSpec kMassAttributes[] = {{"value", true}};
/// What is missing of a tensor, or written below its diagonal, has rules of its own.
constexpr AttributeSpec kInertiaAttributes[] = {{"ixx"}, {"ixy"}, {"ixz"},
                                                {"iyy"}, {"iyz"}, {"izz"}};
constexpr std::string_view kInertiaExtensions[] = {"iyx", "izx", "izy"};
constexpr AttributeSpec kOriginAttributes[] = {{"xyz"}, {"rpy"}, {"quat_xyzw"}};

constexpr AttributeSpec kVisualAttributes[] = {{"name"}};
constexpr ChildSpec kVisualChildren[] = {{"origin", true}, {"geometry", true}, {"material", true}};
constexpr AttributeSpec kCollisionAttributes[] = {{"name"}};
constexpr ChildSpec kCollisionChildren[] = {{"origin", true}, {"geometry", true}};
constexpr std::string_view kCollisionExtensions[] = {
    "group",        "mask",   "concave",         "verbose", "material", "contact_coefficients",
    "max_contacts", "bullet", "drake_compliance"};

constexpr ChildSpec kGeometryChildren[] = {
    {"box"}, {"sphere"}, {"cylinder"}, {"capsule"}, {"mesh"}};
constexpr std::string_view kGeometryExtensions[] = {"plane", "cdf", "ellipsoid", "verbose"};
constexpr AttributeSpec kBoxAttributes[] = {{"size", true}};
constexpr AttributeSpec kSphereAttributes[] = {{"radius", true}};
constexpr AttributeSpec kCylinderAttributes[] = {{"radius", true}, {"length", true}};
constexpr AttributeSpec kMeshAttributes[] = {{"filename", true}, {"scale"}};

constexpr AttributeSpec kMaterialAttributes[] = {{"name", true}};
constexpr ChildSpec kMaterialChildren[] = {{"color", true}, {"texture", true}};
constexpr std::string_view kMaterialExtensions[] = {"specular", "shininess"};
constexpr AttributeSpec kColorAttributes[] = {{"rgba", true}};
constexpr AttributeSpec kTextureAttributes[] = {{"filename"}};

constexpr AttributeSpec kJointAttributes[] = {{"name", true}, {"type"}};
constexpr ChildSpec kJointChildren[] = {
    {"origin", true},     {"parent", true},   {"child", true}, {"axis", true},
    {"limit", true},      {"dynamics", true}, {"mimic", true}, {"safety_controller", true},
    {"calibration", true}};
constexpr std::string_view kJointExtensions[] = {
    "dont_collapse", "joint_properties", "hardwareInterface", "gearbox", "sensor",
    "motor",         "actuator",         "drake_ignore"};
constexpr AttributeSpec kLinkReference[] = {{"link"}};
constexpr AttributeSpec kAxisAttributes[] = {{"xyz", true}};
constexpr AttributeSpec kLimitAttributes[] = {
    {"lower"}, {"upper"}, {"effort"}, {"velocity"}, {"acceleration"}, {"deceleration"}, {"jerk"}};
constexpr AttributeSpec kDynamicsAttributes[] = {{"damping"}, {"friction"}};
constexpr std::string_view kDynamicsExtensions[] = {"spring_stiffness", "spring_reference"};
constexpr AttributeSpec kMimicAttributes[] = {{"joint", true}, {"multiplier"}, {"offset"}};
constexpr AttributeSpec kSafetyAttributes[] = {
    {"soft_lower_limit"}, {"soft_upper_limit"}, {"k_position"}, {"k_velocity", true}};
constexpr AttributeSpec kCalibrationAttributes[] = {
    {"rising"}, {"falling"}, {"reference_position"}};

constexpr ElementSpec kElements[] = {
    {"robot", kRobotAttributes, kRobotChildren, kRobotExtensions},
    {"link", kLinkAttributes, kLinkChildren, kLinkExtensions},
    {"inertial", {}, kInertialChildren, {}},
    {"mass", kMassAttributes, {}, {}},
    {"inertia", kInertiaAttributes, {}, kInertiaExtensions},
    {"origin", kOriginAttributes, {}, {}},
    {"visual", kVisualAttributes, kVisualChildren, kCollisionExtensions},
    {"collision", kCollisionAttributes, kCollisionChildren, kCollisionExtensions},
    {"geometry", {}, kGeometryChildren, kGeometryExtensions},
    {"box", kBoxAttributes, {}, {}},
    {"sphere", kSphereAttributes, {}, {}},
    {"cylinder", kCylinderAttributes, {}, {}},
    {"capsule", kCylinderAttributes, {}, {}},
    {"mesh", kMeshAttributes, {}, {}},
    {"material", kMaterialAttributes, kMaterialChildren, kMaterialExtensions},
    {"color", kColorAttributes, {}, {}},
    {"texture", kTextureAttributes, {}, {}},
    {"joint", kJointAttributes, kJointChildren, kJointExtensions},
    {"parent", kLinkReference, {}, {}},
    {"child", kLinkReference, {}, {}},
    {"axis", kAxisAttributes, {}, {}},
    {"limit", kLimitAttributes, {}, {}},
    {"dynamics", kDynamicsAttributes, {}, kDynamicsExtensions},
    {"mimic", kMimicAttributes, {}, {}},
    {"safety_controller", kSafetyAttributes, {}, {}},
    {"calibration", kCalibrationAttributes, {}, {}},
};

/// Synonyms from SDF, MJCF and English -> URDF names.
constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {
    {"cube", "box"},      {"dimensions", "size"},  {"extents", "size"},    {"factor", "multiplier"},
    {"file", "filename"}, {"force", "effort"},     {"height", "length"},   {"id", "name"},
    {"mass", "value"},    {"max", "upper"},        {"maximum", "upper"},   {"min", "lower"},
    {"minimum", "lower"}, {"orientation", "rpy"},  {"path", "filename"},   {"pose", "origin"},
    {"position", "xyz"},  {"ratio", "multiplier"}, {"rotation", "rpy"},    {"speed", "velocity"},
    {"torque", "effort"}, {"transform", "origin"}, {"translation", "xyz"}, {"uri", "filename"},
    {"url", "filename"},
};

}  // namespace

std::optional<std::string_view> meant_name(std::string_view name,
                                           std::span<const std::string_view> known) {
  if (const auto near = nearest(name, known)) return near;
  for (const auto& [other, own] : kOtherNames) {
    if (name != other) continue;
    if (std::find(known.begin(), known.end(), own) != known.end()) return own;
  }
  return std::nullopt;
}

const ElementSpec* find_element_spec(std::string_view name) {
  const ElementSpec* found =
      std::find_if(std::begin(kElements), std::end(kElements),
                   [&](const ElementSpec& spec) { return is_same(spec.name, name); });
  return found == std::end(kElements) ? nullptr : found;
}

}  // namespace smurf::urdf
