// SPDX-License-Identifier: BSD-3-Clause
// Sources, at be259df: Drake multibody/parsing/detail_urdf_parser.cc, detail_urdf_geometry.cc,
// detail_common.cc and detail_collision_filter_group_resolver.cc; the ranges also from the files
// that these call: shape_specification.cc, proximity_properties.cc, coulomb_friction.cc,
// multibody_plant.cc.
#include "readers/drake_language.hpp"

#include <algorithm>

#include "base/text/words.hpp"

namespace smurf::drake {
namespace {

using enum Value;
using enum Range;
using enum Occurs;

constexpr AttributeSpec kName[] = {{"name"}};
constexpr AttributeSpec kNamedBody[] = {{"name", body}};
constexpr AttributeSpec kNamedFrame[] = {{"name", frame}};
constexpr AttributeSpec kNamedGroup[] = {{"name", group}};
constexpr AttributeSpec kLink[] = {{"link", Value::link}};
constexpr AttributeSpec kMember[] = {{"link", body}};
constexpr AttributeSpec kPose[] = {{"xyz", vector, all, false}, {"rpy", vector, all, false}};
constexpr AttributeSpec kFrame[] = {
    {"name"}, {"link", Value::link}, {"xyz", vector, all, false}, {"rpy", vector, all, false}};
constexpr AttributeSpec kDirection[] = {{"xyz", vector, all, false}};
constexpr AttributeSpec kSurfaceAxis[] = {{"axis", vector}};
constexpr AttributeSpec kJoint[] = {{"name"}, {"type"}};
constexpr AttributeSpec kMimic[] = {
    {"joint", joint}, {"multiplier", number, all, false}, {"offset", number, all, false}};
constexpr AttributeSpec kLimit[] = {{"drake:acceleration", number, not_negative, false}};
constexpr AttributeSpec kTendonJoint[] = {{"name", joint}, {"a", number}};
constexpr AttributeSpec kDynamics[] = {{"coulomb_window", number, all, false}};
constexpr AttributeSpec kGains[] = {{"p", number, not_negative}, {"d", number, not_negative}};
constexpr AttributeSpec kEnabled[] = {{"enabled", choice, all, false}};
constexpr AttributeSpec kCapsule[] = {{"radius", number, positive}, {"length", number, positive}};
constexpr AttributeSpec kEllipsoid[] = {
    {"a", number, positive}, {"b", number, positive}, {"c", number, positive}};
constexpr AttributeSpec kSegment[] = {{"length", number, positive}};
constexpr AttributeSpec kArc[] = {{"radius", number, positive}, {"angle", number}};
constexpr AttributeSpec kNumber[] = {{"value", number}};
constexpr AttributeSpec kNotNegative[] = {{"value", number, not_negative}};
constexpr AttributeSpec kPositive[] = {{"value", number, positive}};
constexpr AttributeSpec kVector[] = {{"value", vector}};
constexpr AttributeSpec kNotNegativeVector[] = {{"value", vector, not_negative}};

/// Rows with the same parent are adjacent.
constexpr ElementSpec kElements[] = {
    {"robot", "link"},
    {"robot", "joint"},
    {"robot", "material"},
    {"robot", "transmission"},
    {"robot", "frame", any, kFrame},
    {"robot", "drake:joint", any, kJoint},
    {"robot", "drake:collision_filter_group", any, kName},
    {"robot", "drake:linear_bushing_rpy"},
    {"robot", "drake:linear_spring_damper"},
    {"robot", "drake:ball_constraint"},
    {"robot", "drake:distance_constraint"},
    {"robot", "drake:tendon_constraint"},

    {"link", "visual"},
    {"link", "collision"},
    {"link", "drake:surface_velocity_axis", at_most_once, kSurfaceAxis},

    {"visual", "geometry", at_most_once},
    {"visual", "material", at_most_once},
    {"visual", "drake:illustration_properties", at_most_once, kEnabled},
    {"visual", "drake:perception_properties", at_most_once, kEnabled},
    {"visual", "drake:accepting_renderer", any, kName},

    {"collision", "geometry", at_most_once},
    {"collision", "drake:proximity_properties", at_most_once},
    {"collision", "drake_compliance", at_most_once},

    {"geometry", "mesh", at_most_once},
    {"geometry", "drake:capsule", at_most_once, kCapsule},
    {"geometry", "drake:ellipsoid", at_most_once, kEllipsoid},

    {"mesh", "drake:declare_convex", at_most_once},

    {"material", "drake:diffuse_map", never},

    {"joint", "limit", at_most_once, kLimit},
    {"joint", "dynamics", any, kDynamics},

    {"transmission", "actuator", once, kName},
    {"transmission", "joint", once, kName},

    {"actuator", "drake:rotor_inertia", at_most_once, kNumber},
    {"actuator", "drake:gear_ratio", at_most_once, kNumber},
    {"actuator", "drake:controller_gains", at_most_once, kGains},

    {"drake:joint", "parent", once, kLink},
    {"drake:joint", "child", once, kLink},
    {"drake:joint", "origin", at_most_once, kPose},
    {"drake:joint", "axis", at_most_once, kDirection},
    {"drake:joint", "dynamics", at_most_once},
    {"drake:joint", "mimic", at_most_once, kMimic},
    {"drake:joint", "drake:screw_thread_pitch", at_most_once, kNumber},
    {"drake:joint", "drake:initial_tangent", at_most_once, kDirection},
    {"drake:joint", "drake:plane_normal", at_most_once, kDirection},
    {"drake:joint", "drake:is_periodic", at_most_once},
    {"drake:joint", "drake:curves", at_most_once},

    {"drake:curves", "drake:line_segment", any, kSegment},
    {"drake:curves", "drake:circular_arc", any, kArc},

    {"drake:collision_filter_group", "drake:member", any, kMember},
    {"drake:collision_filter_group", "drake:member_group", any, kNamedGroup},
    {"drake:collision_filter_group", "drake:ignored_collision_filter_group", any, kNamedGroup},

    {"drake:linear_bushing_rpy", "drake:bushing_frameA", once, kNamedFrame},
    {"drake:linear_bushing_rpy", "drake:bushing_frameC", once, kNamedFrame},
    {"drake:linear_bushing_rpy", "drake:bushing_torque_stiffness", once, kNotNegativeVector},
    {"drake:linear_bushing_rpy", "drake:bushing_torque_damping", once, kNotNegativeVector},
    {"drake:linear_bushing_rpy", "drake:bushing_force_stiffness", once, kNotNegativeVector},
    {"drake:linear_bushing_rpy", "drake:bushing_force_damping", once, kNotNegativeVector},

    {"drake:linear_spring_damper", "drake:linear_spring_damper_body_A", once, kNamedBody},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_body_B", once, kNamedBody},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_p_AP", once, kVector},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_p_BQ", once, kVector},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_free_length", once, kPositive},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_stiffness", once, kNotNegative},
    {"drake:linear_spring_damper", "drake:linear_spring_damper_damping", once, kNotNegative},

    {"drake:ball_constraint", "drake:ball_constraint_body_A", once, kNamedBody},
    {"drake:ball_constraint", "drake:ball_constraint_body_B", once, kNamedBody},
    {"drake:ball_constraint", "drake:ball_constraint_p_AP", once, kVector},
    {"drake:ball_constraint", "drake:ball_constraint_p_BQ", once, kVector},

    {"drake:distance_constraint", "drake:distance_constraint_body_A", once, kNamedBody},
    {"drake:distance_constraint", "drake:distance_constraint_body_B", once, kNamedBody},
    {"drake:distance_constraint", "drake:distance_constraint_p_AP", once, kVector},
    {"drake:distance_constraint", "drake:distance_constraint_p_BQ", once, kVector},
    {"drake:distance_constraint", "drake:distance_constraint_distance", once, kPositive},
    {"drake:distance_constraint", "drake:distance_constraint_stiffness", once, kPositive},
    {"drake:distance_constraint", "drake:distance_constraint_damping", once, kNotNegative},

    {"drake:tendon_constraint", "drake:tendon_constraint_joint", any, kTendonJoint},
    {"drake:tendon_constraint", "drake:tendon_constraint_offset", once, kNumber},
    {"drake:tendon_constraint", "drake:tendon_constraint_lower_limit", once, kNumber},
    {"drake:tendon_constraint", "drake:tendon_constraint_upper_limit", once, kNumber},
    {"drake:tendon_constraint", "drake:tendon_constraint_stiffness", once, kPositive},
    {"drake:tendon_constraint", "drake:tendon_constraint_damping", once, kNotNegative},

    {"drake:proximity_properties", "drake:rigid_hydroelastic", at_most_once},
    {"drake:proximity_properties", "drake:compliant_hydroelastic", at_most_once},
    {"drake:proximity_properties", "drake:soft_hydroelastic", never},
    {"drake:proximity_properties", "drake:mesh_resolution_hint", at_most_once, kNumber},
    {"drake:proximity_properties", "drake:hydroelastic_modulus", at_most_once, kNumber},
    {"drake:proximity_properties", "drake:hydroelastic_margin", at_most_once, kNotNegative},
    {"drake:proximity_properties", "drake:hunt_crossley_dissipation", at_most_once, kNotNegative},
    {"drake:proximity_properties", "drake:point_contact_stiffness", at_most_once, kPositive},
    {"drake:proximity_properties", "drake:relaxation_time", at_most_once, kNotNegative},
    {"drake:proximity_properties", "drake:mu_dynamic", at_most_once, kNotNegative},
    {"drake:proximity_properties", "drake:mu_static", at_most_once, kNotNegative},
};

constexpr std::string_view kOwnJointTypes[] = {"ball", "screw", "universal", "curvilinear"};

}  // namespace

std::span<const ElementSpec> children_of(std::string_view parent) {
  const auto is_child = [&](const ElementSpec& spec) { return is_same(spec.parent, parent); };
  const auto* first = std::find_if(std::begin(kElements), std::end(kElements), is_child);
  return {first, std::find_if_not(first, std::end(kElements), is_child)};
}

bool is_own_name(std::string_view name) {
  return name.starts_with("drake:") || name == "drake_compliance" || name == "drake_ignore";
}

bool is_own_joint_type(std::string_view type) {
  return std::find(std::begin(kOwnJointTypes), std::end(kOwnJointTypes), type) !=
         std::end(kOwnJointTypes);
}

}  // namespace smurf::drake
