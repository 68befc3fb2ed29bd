// SPDX-License-Identifier: BSD-3-Clause
// Sources: urdfdom 3.0.1 and 5.x parsers, the URDF XML specification on the ROS wiki; extensions as
// read by sdformat, Drake, Bullet, MuJoCo, Pinocchio and Isaac.
#include "ast/urdf_schema.hpp"

#include <algorithm>
#include <utility>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"

namespace smurf::urdf {
namespace {

/// Marks an attribute whose absence is reported by a separate rule.
constexpr AttributeSpec usual(AttributeSpec spec) {
  spec.is_usual = true;
  return spec;
}

constexpr AttributeSpec kRobotAttributes[] = {
    {"name", false, "Name of the robot."},
    {"version", false, "Version of URDF; urdfdom accepts 1.0, its newer versions also 1.1 and 1.2.",
     "", "1.0"}};
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

constexpr AttributeSpec kLinkAttributes[] = {
    {"name", true, "Name of the link; joints, motors and sensors refer to it, so it is unique."},
    {"type", false, "From old files; readers ignore it."}};
constexpr ChildSpec kLinkChildren[] = {{"inertial", true}, {"visual"}, {"collision"}};
constexpr std::string_view kLinkExtensions[] = {"contact",      "collision_checking",
                                                "audio_source", "self_collision_checking",
                                                "sensor",       "velocity_decay",
                                                "kinematic",    "selfCollide",
                                                "gravity",      "inertia_from_file",
                                                "bullet",       "self_filter",
                                                "drake_ignore", "fem"};

constexpr ChildSpec kInertialChildren[] = {
    {"origin", true}, {"mass", true, true}, {"inertia", true, true}};
constexpr AttributeSpec kMassAttributes[] = {{"value", true, "Mass of the link.", "kg"}};
/// Separate rules report missing entries of a tensor and entries below its diagonal.
constexpr AttributeSpec kInertiaAttributes[] = {
    usual({"ixx", false, "Moment about the x axis through the centre of mass.", "kg m^2"}),
    usual({"ixy", false, "Product of inertia: minus the integral of x y.", "kg m^2"}),
    usual({"ixz", false, "Product of inertia: minus the integral of x z.", "kg m^2"}),
    usual({"iyy", false, "Moment about the y axis through the centre of mass.", "kg m^2"}),
    usual({"iyz", false, "Product of inertia: minus the integral of y z.", "kg m^2"}),
    usual({"izz", false, "Moment about the z axis through the centre of mass.", "kg m^2"})};
constexpr std::string_view kInertiaExtensions[] = {"iyx", "izx", "izy"};
constexpr AttributeSpec kOriginAttributes[] = {
    usual({"xyz", false, "Position in the frame of the enclosing element.", "m", "0 0 0"}),
    {"rpy", false, "Rotation about the fixed axes x, then y, then z.", "rad", "0 0 0"},
    {"quat_xyzw", false, "Rotation as a quaternion; read since version 1.1 of URDF."}};

constexpr AttributeSpec kVisualAttributes[] = {{"name", false, "Name of the visual."}};
constexpr ChildSpec kVisualChildren[] = {
    {"origin", true}, {"geometry", true, true}, {"material", true}};
constexpr AttributeSpec kCollisionAttributes[] = {{"name", false, "Name of the collision."}};
constexpr ChildSpec kCollisionChildren[] = {{"origin", true}, {"geometry", true, true}};
constexpr std::string_view kCollisionExtensions[] = {
    "group",        "mask",   "concave",          "verbose", "material", "contact_coefficients",
    "max_contacts", "bullet", "drake_compliance", "sdf"};

constexpr ChildSpec kGeometryChildren[] = {
    {"box"}, {"sphere"}, {"cylinder"}, {"capsule"}, {"mesh"}};
constexpr std::string_view kGeometryExtensions[] = {"plane", "cdf", "ellipsoid", "verbose"};
constexpr AttributeSpec kBoxAttributes[] = {
    {"size", true, "Full lengths of the edges along x, y and z.", "m"}};
constexpr AttributeSpec kSphereAttributes[] = {{"radius", true, "Radius.", "m"}};
constexpr AttributeSpec kCylinderAttributes[] = {
    {"radius", true, "Radius.", "m"},
    {"length", true, "Length along z; for a capsule, without its half spheres.", "m"}};
constexpr AttributeSpec kMeshAttributes[] = {
    {"filename", true, "The mesh: a path, or package://NAME/PATH."},
    {"scale", false, "Factors along x, y and z.", "", "1 1 1"}};

constexpr AttributeSpec kMaterialAttributes[] = {{.name = "name",
                                                  .required = true,
                                                  .doc = "Name of the material.",
                                                  .names = NameKind::material}};
constexpr ChildSpec kMaterialChildren[] = {{"color", true}, {"texture", true}};
constexpr std::string_view kMaterialExtensions[] = {"specular", "shininess"};
constexpr AttributeSpec kColorAttributes[] = {
    {"rgba", true, "Red, green, blue and alpha, each from 0 to 1."}};
constexpr AttributeSpec kTextureAttributes[] = {
    usual({"filename", false, "The image: a path, or package://NAME/PATH."})};

constexpr std::string_view kJointTypes[] = {"revolute", "continuous", "prismatic",
                                            "fixed",    "floating",   "planar"};
constexpr AttributeSpec kJointAttributes[] = {
    {"name", true, "Name of the joint; motors and sensors refer to it, so it is unique."},
    usual({"type", false, "How the child moves relative to the parent.", "", "", kJointTypes})};
constexpr ChildSpec kJointChildren[] = {{"origin", true},      {"parent", true, true},
                                        {"child", true, true}, {"axis", true},
                                        {"limit", true},       {"dynamics", true},
                                        {"mimic", true},       {"safety_controller", true},
                                        {"calibration", true}};
constexpr std::string_view kJointExtensions[] = {
    "dont_collapse", "joint_properties", "hardwareInterface", "gearbox", "sensor",
    "motor",         "actuator",         "drake_ignore"};
constexpr AttributeSpec kLinkReference[] = {
    usual({.name = "link", .doc = "Name of the link.", .names = NameKind::link})};
constexpr AttributeSpec kAxisAttributes[] = {
    {"xyz", true, "Direction in the joint's frame, of length 1.", "", "1 0 0"}};
constexpr AttributeSpec kLimitAttributes[] = {
    usual({"lower", false, "Lowest position.", "rad or m", "0"}),
    usual({"upper", false, "Highest position.", "rad or m", "0"}),
    usual({"effort", false, "Largest torque or force.", "N m or N"}),
    usual({"velocity", false, "Largest speed.", "rad/s or m/s"}),
    {"acceleration", false, "Largest acceleration; read since version 1.2 of URDF.",
     "rad/s^2 or m/s^2"},
    {"deceleration", false, "Largest deceleration; read since version 1.2 of URDF.",
     "rad/s^2 or m/s^2"},
    {"jerk", false, "Largest jerk; read since version 1.2 of URDF.", "rad/s^3 or m/s^3"}};
constexpr AttributeSpec kDynamicsAttributes[] = {
    {"damping", false, "Viscous damping.", "N m s/rad or N s/m", "0"},
    {"friction", false, "Static friction.", "N m or N", "0"}};
constexpr std::string_view kDynamicsExtensions[] = {"spring_stiffness", "spring_reference"};
constexpr AttributeSpec kMimicAttributes[] = {
    {.name = "joint",
     .required = true,
     .doc = "Joint that this one follows.",
     .names = NameKind::joint},
    {"multiplier", false, "Factor on the position of that joint.", "", "1"},
    {"offset", false, "Offset that is added to the result.", "rad or m", "0"}};
constexpr AttributeSpec kSafetyAttributes[] = {
    {"soft_lower_limit", false, "Where the controller begins to limit the position.", "rad or m",
     "0"},
    {"soft_upper_limit", false, "Where the controller begins to limit the position.", "rad or m",
     "0"},
    {"k_position", false, "Relation between position and velocity limits.", "", "0"},
    {"k_velocity", true, "Relation between effort and velocity limits."}};
constexpr AttributeSpec kCalibrationAttributes[] = {
    {"rising", false, "Position at which the reference rises.", "rad or m"},
    {"falling", false, "Position at which the reference falls.", "rad or m"},
    {"reference_position", false, "Position of the reference mark.", "rad or m"}};

constexpr ElementSpec kElements[] = {
    {"robot", kRobotAttributes, kRobotChildren, kRobotExtensions,
     "A robot: links, and joints between them."},
    {"link", kLinkAttributes, kLinkChildren, kLinkExtensions, "A rigid body."},
    {"inertial", {}, kInertialChildren, {}, "Mass, centre of mass and inertia of the link."},
    {"mass", kMassAttributes, {}, {}, "Mass of the link."},
    {"inertia",
     kInertiaAttributes,
     {},
     kInertiaExtensions,
     "Inertia about the centre of mass, in the axes of the inertial frame."},
    {"origin",
     kOriginAttributes,
     {},
     {},
     "Pose in the frame of the enclosing element; for a joint, in the frame of the parent link."},
    {"visual", kVisualAttributes, kVisualChildren, kCollisionExtensions,
     "The appearance of the link."},
    {"collision", kCollisionAttributes, kCollisionChildren, kCollisionExtensions,
     "The shape of the link for collision detection."},
    {"geometry", {}, kGeometryChildren, kGeometryExtensions, "One shape."},
    {"box", kBoxAttributes, {}, {}, "A box around the origin."},
    {"sphere", kSphereAttributes, {}, {}, "A sphere around the origin."},
    {"cylinder", kCylinderAttributes, {}, {}, "A cylinder around the origin, its axis along z."},
    {"capsule",
     kCylinderAttributes,
     {},
     {},
     "A cylinder with half spheres at its ends, its axis along z; read since version 1.1 of URDF."},
    {"mesh", kMeshAttributes, {}, {}, "The triangles of a mesh file."},
    {"material", kMaterialAttributes, kMaterialChildren, kMaterialExtensions,
     "A colour or a texture, with a name that visuals share."},
    {"color", kColorAttributes, {}, {}, "A colour."},
    {"texture", kTextureAttributes, {}, {}, "An image."},
    {"joint", kJointAttributes, kJointChildren, kJointExtensions,
     "How a child link moves relative to its parent link."},
    {"parent", kLinkReference, {}, {}, "The link that carries the joint."},
    {"child", kLinkReference, {}, {}, "The link that the joint moves."},
    {"axis",
     kAxisAttributes,
     {},
     {},
     "The axis of a revolute, continuous or prismatic joint, the normal of a planar one."},
    {"limit",
     kLimitAttributes,
     {},
     {},
     "Limits of the joint; revolute and prismatic joints need them."},
    {"dynamics",
     kDynamicsAttributes,
     {},
     kDynamicsExtensions,
     "Damping and friction of the joint."},
    {"mimic", kMimicAttributes, {}, {}, "The joint follows another one."},
    {"safety_controller",
     kSafetyAttributes,
     {},
     {},
     "Limits of the controller within those of the joint."},
    {"calibration", kCalibrationAttributes, {}, {}, "Where the joint is calibrated."},
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
  // A prefix marks another vocabulary, not a misspelling; the element that it replaces is missing.
  if (name.find(':') != std::string_view::npos) return std::nullopt;
  if (const auto near = nearest(name, known)) return near;
  for (const auto& [other, own] : kOtherNames) {
    if (name != other) continue;
    if (std::find(known.begin(), known.end(), own) != known.end()) return own;
  }
  return std::nullopt;
}

std::span<const ElementSpec> all_element_specs() { return kElements; }

const ElementSpec* find_element_spec(std::string_view name) {
  const ElementSpec* found =
      std::find_if(std::begin(kElements), std::end(kElements),
                   [&](const ElementSpec& spec) { return is_same(spec.name, name); });
  return found == std::end(kElements) ? nullptr : found;
}

}  // namespace smurf::urdf
