// SPDX-License-Identifier: BSD-3-Clause
// A SMURF model as written: the main file and the annotation sections, each value with its place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/pose.hpp"
#include "smurf/source.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Red, green, blue, alpha in 0..1; components may be absent.
struct Color {
  Field<double> r, g, b, a;
};

using NameList = std::vector<Spanned<std::string>>;

/// Members that entries of all sections have. Keys without a member are only in the tree: `node` is
/// the entry in the document of `span.source`.
struct Annotation {
  Span span;
  yaml::NodeId node = yaml::kNoNode;
  Span section;  ///< the section's key as written ("joints"); some readers do not know all of them
  Field<std::string> name;
};

/// An entry of `materials`.
struct MaterialAnnotation : Annotation {
  Field<Color> ambient_color, diffuse_color, specular_color, emission_color;
  Field<double> shininess, transparency;
  Field<std::string> diffuse_texture, normal_texture, displacement_texture;
};

/// An entry of `motors`: what drives a joint, with its limits and its controller.
struct Motor : Annotation {
  Field<std::string> joint, type;
  Field<double> max_speed, max_effort;       ///< rad/s or m/s; N m or N
  Field<double> min_value, max_value;        ///< rad or m
  Field<double> min_position, max_position;  ///< rad or m; newer names, preferred by MARS
  Field<double> p, i, d;
  Field<std::string> mimic_motor;
  Field<double> mimic_multiplier, mimic_offset;
};

/// An entry of `sensors`.
struct Sensor : Annotation {
  Field<std::string> type, link, joint;
  Field<NameList> id, links, joints, motors, collisions;  ///< targets by name
  Field<double> rate;
};

/// An entry of `controllers`: a plug-in of MARS with its inputs and outputs.
struct Controller : Annotation {
  Field<NameList> sensors, motors;
  Field<double> rate;
  Field<std::string> dylib_path;
};

/// An entry of `collision`: which groups a collision of the URDF collides with.
struct CollisionAnnotation : Annotation {
  Field<std::string> link;
  Field<std::int64_t> bitmask;
};

/// An entry of `visuals`: the material of a visual of the URDF.
struct VisualAnnotation : Annotation {
  Field<std::string> link, material_name;
};

/// An entry of `links`.
struct LinkAnnotation : Annotation {
  Field<std::string> link;  ///< MARS 2 selects entries by this key, MARS by `name`
};

/// An entry of `nodes`: changes a node of the model by name, or makes a new one.
struct NodeAnnotation : Annotation {
  Field<std::string> parent, viz_link, material_name;
};

/// An entry of `joints`.
struct JointAnnotation : Annotation {
  Field<std::string> type, parent, child;
  Field<double> low_stop, high_stop;  ///< axis 1; rad or m
  Field<Vector3> axis;
};

/// An entry of `lights`.
struct Light : Annotation {
  Field<Vector3> position, look_at;  ///< world frame, m
  Field<Color> ambient, diffuse, specular;
  Field<std::int64_t> type;  ///< 1 omni, 2 spot
  Field<double> angle, exponent;
  Field<double> constant_attenuation, linear_attenuation, quadratic_attenuation;
  Field<bool> directional;
  Field<std::string> node_name;
};

/// The content of `graphics`. MARS accepts a single mapping and a list.
struct Graphics : Annotation {
  Field<Color> clear_color, fog_color;
  Field<bool> fog_enabled;
  Field<double> fog_density, fog_start, fog_end;
};

/// One entry of `poses`: named joint positions.
struct JointPoseSet : Annotation {
  /// The position of one joint.
  struct Entry {
    Spanned<std::string> name;  ///< a motor (MARS) or joint (Phobos)
    Field<double> position;     ///< rad or m
  };
  std::vector<Entry> joints;
};

/// An entry of `submechanisms`: joints that belong together, as HyRoDyn solves them.
struct Submechanism : Annotation {
  Field<std::string> contextual_name, type;
  Field<NameList> joint_names, joint_names_spanning_tree, joint_names_active,
      joint_names_independent;
};

/// A part of a human that wears the mechanism; like a submechanism.
struct Exoskeleton : Annotation {
  Field<std::string> contextual_name, around;
  Field<NameList> joint_names, joint_names_spanning_tree, joint_names_dependent;
};

/// The tasks of Rock that provide the position of a joint and drive it. `name` is the joint.
struct JointTask : Annotation {
  Field<std::string> provider, port, driver;
};

/// Where another model can be attached.
struct Interface : Annotation {
  Field<std::string> parent, type, direction;
  Field<Vector3> position, rotation;  ///< in the parent link's frame; m, rad (rpy)
};

/// An entry of the mapping `submodels`; `name` is its key.
struct Submodel : Annotation {
  Field<std::string> export_directory, start;  ///< `start` is a link
  Field<NameList> stop;                        ///< links
};

/// A section that the format does not define, kept as it is.
struct CustomSection {
  Spanned<std::string> name;
  yaml::NodeId node = yaml::kNoNode;
  Span span;
};

/// The sections of one file, or of all files of a model after merging (lists in file order).
struct Annotations {
  std::vector<MaterialAnnotation> materials;
  std::vector<Motor> motors;
  std::vector<Sensor> sensors;
  std::vector<Controller> controllers;
  std::vector<CollisionAnnotation> collisions;
  std::vector<VisualAnnotation> visuals;
  std::vector<LinkAnnotation> links;
  std::vector<NodeAnnotation> nodes;
  std::vector<JointAnnotation> joints;
  std::vector<JointTask> joint_tasks;
  std::vector<Light> lights;
  std::vector<Graphics> graphics;
  std::vector<JointPoseSet> poses;
  std::vector<Submechanism> submechanisms;
  std::vector<Exoskeleton> exoskeletons;
  std::vector<Interface> interfaces;
  std::vector<Submodel> submodels;
  std::vector<CustomSection> custom;
};

/// The section names the format defines, canonical names first ("motors", ..., then aliases).
std::vector<std::string_view> section_names();

/// A main file (.smurf).
struct Model {
  Field<std::string> modelname;
  Field<std::string> version;
  Field<NameList> files;
  Annotations inline_annotations;
  /// Keys that are neither known nor sections: scene-entity keys, plug-in data.
  std::vector<CustomSection> extra;
};

}  // namespace smurf
