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

/// The rows of an element for checks and help: the form is that of the member, which is left out.
template <const auto& Rows>
constexpr auto kSpecs = [] {
  std::array<AttributeSpec, std::size(Rows)> specs{};
  for (std::size_t i = 0; i < specs.size(); ++i) {
    specs[i] = Rows[i].spec;
    const Form forms[] = {specs[i].form, Form::text, Form::number, Form::three_numbers,
                          Form::four_numbers};
    specs[i].form = forms[Rows[i].member.index()];
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
                                                "drake_ignore", "fem",
                                                "plugin"};

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
    "motor",         "actuator",         "drake_ignore",      "plugin"};
constexpr std::string_view kDynamicsExtensions[] = {"spring_stiffness", "spring_reference"};

constexpr ElementSpec kElements[] = {
    {"robot", "A robot: links, and joints between them.", kSpecs<kRobot>, kRobotChildren,
     kRobotExtensions},
    {"link", "A rigid body.", kSpecs<kLink>, kLinkChildren, kLinkExtensions},
    {"inertial", "Mass, centre of mass and inertia of the link.", {}, kInertialChildren},
    {"mass", "Mass of the link.", kSpecs<kMass>},
    {"inertia",
     "Inertia about the centre of mass, in the axes of the inertial frame.",
     kSpecs<kInertia>,
     {},
     kInertiaExtensions},
    {"origin",
     "Pose in the frame of the enclosing element; for a joint, in the frame of the parent link.",
     kSpecs<kOrigin>},
    {"visual", "The appearance of the link.", kSpecs<kVisual>, kVisualChildren,
     kCollisionExtensions},
    {"collision", "The shape of the link for collision detection.", kSpecs<kCollision>,
     kCollisionChildren, kCollisionExtensions},
    {"geometry", "One shape.", {}, kGeometryChildren, kGeometryExtensions},
    {"box", "A box around the origin.", kSpecs<kBox>},
    {"sphere", "A sphere around the origin.", kSpecs<kSphere>},
    {"cylinder", "A cylinder around the origin, its axis along z.", kSpecs<kCylinder>},
    {"capsule",
     "A cylinder with half spheres at its ends, its axis along z; read since version 1.1 of URDF.",
     kSpecs<kCapsule>},
    {"mesh", "The triangles of a mesh file.", kSpecs<kMesh>},
    {"material", "A colour or a texture, with a name that visuals share.", kSpecs<kMaterial>,
     kMaterialChildren, kMaterialExtensions},
    {"color", "A colour.", kSpecs<kColor>},
    {"texture", "An image.", kSpecs<kTexture>},
    {"joint", "How a child link moves relative to its parent link.", kSpecs<kJoint>, kJointChildren,
     kJointExtensions},
    {"parent", "The link that carries the joint.", kSpecs<kParent>},
    {"child", "The link that the joint moves.", kSpecs<kChild>},
    {"axis", "The axis of a revolute, continuous or prismatic joint, the normal of a planar one.",
     kSpecs<kAxis>},
    {"limit", "Limits of the joint; revolute and prismatic joints need them.", kSpecs<kLimit>},
    {"dynamics", "Damping and friction of the joint.", kSpecs<kDynamics>, {}, kDynamicsExtensions},
    {"mimic", "The joint follows another one.", kSpecs<kMimic>},
    {"safety_controller", "Limits of the controller within those of the joint.",
     kSpecs<kSafetyController>},
    {"calibration", "Where the joint is calibrated.", kSpecs<kCalibration>},
};

/// Synonyms from SDF, MJCF and English -> URDF names.
constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {
    {"cube", "box"},
    {"dimensions", "size"},
    {"extents", "size"},
    {"factor", "multiplier"},
    {"file", "filename"},
    {"force", "effort"},
    {"height", "length"},
    {"id", "name"},
    {"mass", "value"},
    {"max", "upper"},
    {"maximum", "upper"},
    {"min", "lower"},
    {"minimum", "lower"},
    {"orientation", "rpy"},
    {"path", "filename"},
    {"pose", "origin"},
    {"position", "xyz"},
    {"ratio", "multiplier"},
    {"rotation", "rpy"},
    {"speed", "velocity"},
    {"soft_lower", "soft_lower_limit"},
    {"soft_upper", "soft_upper_limit"},
    {"torque", "effort"},
    {"transform", "origin"},
    {"translation", "xyz"},
    {"uri", "filename"},
    {"url", "filename"},
};

template <class Spec>
const Spec* row_of(std::span<const Spec> table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Spec& spec) { return is_same(spec.name, name); });
  return found == table.end() ? nullptr : &*found;
}

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
  return row_of<ElementSpec>(kElements, name);
}

const AttributeSpec* ElementSpec::attribute(std::string_view wanted) const {
  return row_of(attributes, wanted);
}

const ChildSpec* ElementSpec::child(std::string_view wanted) const {
  return row_of(children, wanted);
}

}  // namespace smurf::urdf
