// SPDX-License-Identifier: BSD-3-Clause
// Sources: those of the attributes; extensions as read by sdformat, Drake, Bullet, MuJoCo,
// Pinocchio and Isaac.
#include "ast/urdf_schema.hpp"

#include <algorithm>
#include <utility>

#include "ast/urdf_attributes.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"

namespace smurf::urdf {
namespace {

/// The form of a value that is read into this member.
template <class T>
constexpr Form form_of(const Attribute<T>& row) {
  if (std::holds_alternative<Field<std::string> T::*>(row.member)) return Form::text;
  if (std::holds_alternative<Field<Vector3> T::*>(row.member)) return Form::three_numbers;
  if (std::holds_alternative<Field<std::array<double, 4>> T::*>(row.member)) {
    return Form::four_numbers;
  }
  return row.spec.form;
}

/// The rows of an element without their members.
template <const auto& Rows>
constexpr auto kSpecs = [] {
  std::array<AttributeSpec, std::size(Rows)> specs{};
  for (std::size_t i = 0; i < specs.size(); ++i) {
    specs[i] = Rows[i].spec;
    specs[i].form = form_of(Rows[i]);
  }
  return specs;
}();

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
constexpr std::string_view kInertiaExtensions[] = {"iyx", "izx", "izy"};

constexpr ChildSpec kVisualChildren[] = {
    {"origin", true}, {"geometry", true, true}, {"material", true}};
constexpr ChildSpec kCollisionChildren[] = {{"origin", true}, {"geometry", true, true}};
constexpr std::string_view kCollisionExtensions[] = {
    "group",        "mask",   "concave",          "verbose", "material", "contact_coefficients",
    "max_contacts", "bullet", "drake_compliance", "sdf"};

constexpr ChildSpec kGeometryChildren[] = {
    {"box"}, {"sphere"}, {"cylinder"}, {"capsule"}, {"mesh"}};
constexpr std::string_view kGeometryExtensions[] = {"plane", "cdf", "ellipsoid", "verbose"};

constexpr ChildSpec kMaterialChildren[] = {{"color", true}, {"texture", true}};
constexpr std::string_view kMaterialExtensions[] = {"specular", "shininess"};

constexpr ChildSpec kJointChildren[] = {
    {"origin", true}, {"parent", true, true}, {"child", true, true},
    {"axis", true},   {"calibration", true},  {"dynamics", true},
    {"limit", true},  {"mimic", true},        {"safety_controller", true}};
constexpr std::string_view kJointExtensions[] = {
    "dont_collapse", "joint_properties", "hardwareInterface", "gearbox", "sensor",
    "motor",         "actuator",         "drake_ignore"};
constexpr std::string_view kDynamicsExtensions[] = {"spring_stiffness", "spring_reference"};

constexpr ElementSpec kElements[] = {
    {"robot", kSpecs<kRobot>, kRobotChildren, kRobotExtensions,
     "A robot: links, and joints between them."},
    {"link", kSpecs<kLink>, kLinkChildren, kLinkExtensions, "A rigid body."},
    {"inertial", {}, kInertialChildren, {}, "Mass, centre of mass and inertia of the link."},
    {"mass", kSpecs<kMass>, {}, {}, "Mass of the link."},
    {"inertia",
     kSpecs<kInertia>,
     {},
     kInertiaExtensions,
     "Inertia about the centre of mass, in the axes of the inertial frame."},
    {"origin",
     kSpecs<kOrigin>,
     {},
     {},
     "Pose in the frame of the enclosing element; for a joint, in the frame of the parent link."},
    {"visual", kSpecs<kVisual>, kVisualChildren, kCollisionExtensions,
     "The appearance of the link."},
    {"collision", kSpecs<kCollision>, kCollisionChildren, kCollisionExtensions,
     "The shape of the link for collision detection."},
    {"geometry", {}, kGeometryChildren, kGeometryExtensions, "One shape."},
    {"box", kSpecs<kBox>, {}, {}, "A box around the origin."},
    {"sphere", kSpecs<kSphere>, {}, {}, "A sphere around the origin."},
    {"cylinder", kSpecs<kCylinder>, {}, {}, "A cylinder around the origin, its axis along z."},
    {"capsule",
     kSpecs<kCapsule>,
     {},
     {},
     "A cylinder with half spheres at its ends, its axis along z; read since version 1.1 of URDF."},
    {"mesh", kSpecs<kMesh>, {}, {}, "The triangles of a mesh file."},
    {"material", kSpecs<kMaterial>, kMaterialChildren, kMaterialExtensions,
     "A colour or a texture, with a name that visuals share."},
    {"color", kSpecs<kColor>, {}, {}, "A colour."},
    {"texture", kSpecs<kTexture>, {}, {}, "An image."},
    {"joint", kSpecs<kJoint>, kJointChildren, kJointExtensions,
     "How a child link moves relative to its parent link."},
    {"parent", kSpecs<kParent>, {}, {}, "The link that carries the joint."},
    {"child", kSpecs<kChild>, {}, {}, "The link that the joint moves."},
    {"axis",
     kSpecs<kAxis>,
     {},
     {},
     "The axis of a revolute, continuous or prismatic joint, the normal of a planar one."},
    {"limit",
     kSpecs<kLimit>,
     {},
     {},
     "Limits of the joint; revolute and prismatic joints need them."},
    {"dynamics", kSpecs<kDynamics>, {}, kDynamicsExtensions, "Damping and friction of the joint."},
    {"mimic", kSpecs<kMimic>, {}, {}, "The joint follows another one."},
    {"safety_controller",
     kSpecs<kSafetyController>,
     {},
     {},
     "Limits of the controller within those of the joint."},
    {"calibration", kSpecs<kCalibration>, {}, {}, "Where the joint is calibrated."},
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
