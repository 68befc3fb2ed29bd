// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:391-403, JointData.cpp:89-164, JointPhysics.cpp:127-420; rock-cpp/smurf
// Joint.cpp:101-124; mars_ode_physics Joint.cpp:180-193; Phobos representation.py:2001-2119.
#include "ast/sections.hpp"

namespace smurf::sections {
namespace {

using enum ValueType;

constexpr std::string_view kTypes[] = {
    "hinge", "hinge2", "slider", "ball", "universal", "fixed", "istruct-spine",
    "1",     "2",      "3",      "4",    "5",         "6",     "7"};
constexpr std::string_view kAnchors[] = {"node1", "node2", "center", "custom", "1", "2", "3", "4"};
constexpr std::string_view kUrdfTypes[] = {"revolute", "continuous", "prismatic", "floating",
                                           "planar",   "fixed",      "unknown",   "revolute2",
                                           "screw",    "ball",       "universal"};

constexpr Key<JointAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of a joint of the URDF.",
      .required = true,
      .names = {NameKind::joint}},
     &JointAnnotation::name},
    {{.name = "type",
      .type = text,
      .doc = "Joint of the physics engine that replaces the URDF's type, by name or number.",
      .choices = kTypes},
     &JointAnnotation::type},
    {{.name = "parent",
      .type = text,
      .doc = "Parent link, written by Phobos 2.",
      .names = {NameKind::link}},
     &JointAnnotation::parent},
    {{.name = "child",
      .type = text,
      .doc = "Child link, written by Phobos 2.",
      .names = {NameKind::link}},
     &JointAnnotation::child},
    {{.name = "axis1",
      .type = vector3,
      .doc =
          "First axis in the world frame, with the root link at the origin and all joints at 0."},
     &JointAnnotation::axis},
    {{.name = "lowStopAxis1",
      .type = number,
      .doc = "Lower stop of axis 1, with the sign of the physics engine: the URDF position stays "
             "above -highStopAxis1. Both stops work only when this one is not 0 or there is a "
             "spring.",
      .unit = "rad or m",
      .fallback = "0"},
     &JointAnnotation::low_stop},
    {{.name = "highStopAxis1",
      .type = number,
      .doc = "Upper stop of axis 1: the URDF position stays below -lowStopAxis1.",
      .unit = "rad or m",
      .fallback = "0"},
     &JointAnnotation::high_stop},
};

constexpr KeySpec kDependencyKeys[] = {
    {.name = "joint", .type = text, .doc = "Joint that is followed.", .names = {NameKind::joint}},
    {.name = "multiplier", .type = number, .doc = "Factor on its position."},
    {.name = "offset", .type = number, .doc = "Added to it.", .unit = "rad or m"},
};

constexpr KeySpec kAxisKeys[] = {
    {.name = "name", .type = text, .doc = "Name of the axis."},
    {.name = "axis", .type = any, .doc = "Direction of the axis."},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "axis2", .type = vector3, .doc = "Second axis in the world frame."},
    {.name = "lowStopAxis2",
     .type = number,
     .doc = "Lower stop of axis 2.",
     .unit = "rad or m",
     .fallback = "0"},
    {.name = "highStopAxis2",
     .type = number,
     .doc = "Upper stop of axis 2.",
     .unit = "rad or m",
     .fallback = "0"},
    {.name = "spring_const_constraint_axis1",
     .type = number,
     .doc = "Spring constant of axis 1.",
     .unit = "N m/rad or N/m",
     .fallback = "0",
     .minimum = 0},
    {.name = "damping_const_constraint_axis1",
     .type = number,
     .doc = "Damping of axis 1.",
     .unit = "N m s/rad or N s/m",
     .fallback = "0",
     .minimum = 0},
    {.name = "spring_const_constraint_axis2",
     .type = number,
     .doc = "Spring constant of axis 2.",
     .unit = "N m/rad or N/m",
     .fallback = "0",
     .minimum = 0},
    {.name = "damping_const_constraint_axis2",
     .type = number,
     .doc = "Damping of axis 2.",
     .unit = "N m s/rad or N s/m",
     .fallback = "0",
     .minimum = 0},
    {.name = "springStiffness",
     .type = number,
     .doc = "Spring constant, for rock-cpp/smurf and MARS 2.",
     .unit = "N m/rad or N/m",
     .minimum = 0},
    {.name = "springDamping",
     .type = number,
     .doc = "Damping, for rock-cpp/smurf and MARS 2.",
     .unit = "N m s/rad or N s/m",
     .minimum = 0},
    {.name = "damping",
     .type = number,
     .doc = "Damping, written by Phobos 2.",
     .unit = "N m s/rad or N s/m",
     .minimum = 0},
    {.name = "friction",
     .type = number,
     .doc = "Friction, written by Phobos 2.",
     .unit = "N m or N",
     .minimum = 0},
    {.name = "frictionCoefficient", .type = number, .doc = "Friction, for MARS 2.", .minimum = 0},
    {.name = "angle1_offset",
     .type = number,
     .doc = "Added to the position of axis 1.",
     .unit = "rad",
     .fallback = "0"},
    {.name = "angle2_offset",
     .type = number,
     .doc = "Added to the position of axis 2.",
     .unit = "rad",
     .fallback = "0"},
    {.name = "anchorpos",
     .type = text,
     .doc = "Where the joint is: at the parent (node1), at the child (node2), between them, or at "
            "`anchor`.",
     .fallback = "\"node2\"",
     .choices = kAnchors},
    {.name = "anchor",
     .type = vector3,
     .doc = "Place of the joint with `anchorpos: custom`.",
     .unit = "m"},
    {.name = "invertAxis",
     .type = boolean,
     .doc = "Turn the signs of position and motor around.",
     .fallback = "true"},
    {.name = "jointCFM",
     .type = number,
     .doc = "Constraint force mixing of the joint.",
     .fallback = "0",
     .minimum = 0},
    {.name = "minPosition",
     .type = number,
     .doc = "Read by MARS 2; the URDF's limit wins.",
     .unit = "rad or m"},
    {.name = "maxPosition",
     .type = number,
     .doc = "Read by MARS 2; the URDF's limit wins.",
     .unit = "rad or m"},
    {.name = "maxEffort",
     .type = number,
     .doc = "Read by MARS 2; the URDF's limit wins.",
     .unit = "N m or N",
     .minimum = 0},
    {.name = "maxVelocity",
     .type = number,
     .doc = "Read by MARS 2; the URDF's limit wins.",
     .unit = "rad/s or m/s",
     .minimum = 0},
    {.name = "noDataPackage",
     .type = boolean,
     .doc = "Publish no data of this joint.",
     .fallback = "false"},
    {.name = "reducedDataPackage",
     .type = boolean,
     .doc = "Publish less data of this joint.",
     .fallback = "true"},
    {.name = "joint_type",
     .type = text,
     .doc = "Type of the joint, written by Phobos 2.",
     .choices = kUrdfTypes},
    {.name = "joint_dependencies",
     .type = list,
     .doc = "Joints that this one follows (Phobos 2).",
     .members = kDependencyKeys},
    {.name = "cut_joint", .type = boolean, .doc = "The joint closes a loop (Phobos 2)."},
    {.name = "constraint_axes",
     .type = list,
     .doc = "Axes of a joint that closes a loop.",
     .members = kAxisKeys},
    {.name = "motor",
     .type = text,
     .doc = "Motor that drives the joint (Phobos 2).",
     .names = {NameKind::motor}},
    {.name = "gearbox_ratio", .type = number, .doc = "Ratio of the gearbox (Phobos 2)."},
    {.name = "gearbox_reference_body",
     .type = text,
     .doc = "Link that carries the gearbox.",
     .names = {NameKind::link}},
    {.name = "screw_thread_pitch", .type = number, .doc = "Pitch of a screw joint."},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<JointAnnotation>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<JointAnnotation>(kKeys, {kMoreKeys}, "joint", entry, section, out.joints, sink);
}

constexpr std::string_view kAliases[] = {"joints"};

}  // namespace

constinit const SectionSpec joint{.name = "joint",
                                  .aliases = kAliases,
                                  .entry = "joint",
                                  .doc = "Changes to URDF joints.",
                                  .filtered_keys = keys,
                                  .read = read,
                                  .entries = entries_of<&Annotations::joints>};

}  // namespace smurf::sections
