// SPDX-License-Identifier: BSD-3-Clause
// Entries of annotation sections. Units are those of the files.
#include "reference.hpp"
#include "smurf/model.hpp"

namespace smurf::python {
namespace {

template <class T>
ReferenceClass<T> entry(py::module_& module, const char* name, const char* doc) {
  ReferenceClass<T> made(module, name, doc);
  made.template field_of<Annotation>("name", &Annotation::name, "Name.");
  return made;
}

void bind_actuation(py::module_& module) {
  entry<Motor>(module, "Motor", "An entry of `motors`.")
      .field("joint", &Motor::joint, "Joint that it drives.")
      .field("type", &Motor::type, "\"PID\", \"DC\", ...")
      .field("max_speed", &Motor::max_speed, "rad/s or m/s.")
      .field("max_effort", &Motor::max_effort, "N m or N.")
      .field("min_value", &Motor::min_value, "Lowest commanded position, rad or m.")
      .field("max_value", &Motor::max_value, "Highest commanded position, rad or m.")
      .field("min_position", &Motor::min_position, "Newer name of min_value; MARS prefers it.")
      .field("max_position", &Motor::max_position, "Newer name of max_value; MARS prefers it.")
      .field("p", &Motor::p, "Proportional gain.")
      .field("i", &Motor::i, "Integral gain; MARS measures time in milliseconds.")
      .field("d", &Motor::d, "Differential gain; MARS measures time in milliseconds.")
      .field("mimic_motor", &Motor::mimic_motor, "Motor that it follows.")
      .field("mimic_multiplier", &Motor::mimic_multiplier, "Factor on the leader's position.")
      .field("mimic_offset", &Motor::mimic_offset, "Added to that, rad or m.");
  entry<Sensor>(module, "Sensor", "An entry of `sensors`.")
      .field("type", &Sensor::type, "\"JointPosition\", \"CameraSensor\", ...")
      .field("link", &Sensor::link, "Link that it is on.")
      .field("joint", &Sensor::joint, "Joint that it is on.")
      .field("id", &Sensor::id, "What it measures: names of links, joints, motors or collisions.")
      .field("links", &Sensor::links, "Links that it measures.")
      .field("joints", &Sensor::joints, "Joints that it measures.")
      .field("motors", &Sensor::motors, "Motors that it measures.")
      .field("collisions", &Sensor::collisions, "Collisions that it measures.")
      .field("rate", &Sensor::rate, "How often it measures, as the file has it.");
  entry<Controller>(module, "Controller", "An entry of `controllers`.")
      .field("sensors", &Controller::sensors, "Sensors that it reads.")
      .field("motors", &Controller::motors, "Motors that it commands.")
      .field("rate", &Controller::rate, "How often it runs, as the file has it.")
      .field("dylib_path", &Controller::dylib_path, "Library with its code.");
}

void bind_elements(py::module_& module) {
  entry<MaterialAnnotation>(module, "MaterialAnnotation", "An entry of `materials`.")
      .field("ambient_color", &MaterialAnnotation::ambient_color,
             "r, g, b, a; each 0 to 1 or None.")
      .field("diffuse_color", &MaterialAnnotation::diffuse_color,
             "r, g, b, a; each 0 to 1 or None.")
      .field("specular_color", &MaterialAnnotation::specular_color,
             "r, g, b, a; each 0 to 1 or None.")
      .field("emission_color", &MaterialAnnotation::emission_color,
             "r, g, b, a; each 0 to 1 or None.")
      .field("shininess", &MaterialAnnotation::shininess, "Exponent of the highlight.")
      .field("transparency", &MaterialAnnotation::transparency, "0 to 1.")
      .field("diffuse_texture", &MaterialAnnotation::diffuse_texture, "Image file.")
      .field("normal_texture", &MaterialAnnotation::normal_texture, "Image file.")
      .field("displacement_texture", &MaterialAnnotation::displacement_texture, "Image file.");
  entry<CollisionAnnotation>(module, "CollisionAnnotation", "An entry of `collision`.")
      .field("link", &CollisionAnnotation::link, "Link of the collision.")
      .field("bitmask", &CollisionAnnotation::bitmask,
             "Two shapes touch when their masks share a bit.");
  entry<VisualAnnotation>(module, "VisualAnnotation", "An entry of `visuals`.")
      .field("link", &VisualAnnotation::link, "Link of the visual.")
      .field("material_name", &VisualAnnotation::material_name, "Material.");
  entry<LinkAnnotation>(module, "LinkAnnotation", "An entry of `link`.")
      .field("link", &LinkAnnotation::link, "The link, for MARS 2.");
  entry<NodeAnnotation>(module, "NodeAnnotation", "An entry of `nodes`.")
      .field("parent", &NodeAnnotation::parent, "Node above.")
      .field("viz_link", &NodeAnnotation::viz_link, "Link.")
      .field("material_name", &NodeAnnotation::material_name, "Material.");
  entry<JointAnnotation>(module, "JointAnnotation", "An entry of `joint`.")
      .field("type", &JointAnnotation::type, "Type, for MARS.")
      .field("parent", &JointAnnotation::parent, "Parent link.")
      .field("child", &JointAnnotation::child, "Child link.")
      .field("low_stop", &JointAnnotation::low_stop, "Lower stop of axis 1, rad or m.")
      .field("high_stop", &JointAnnotation::high_stop, "Upper stop of axis 1, rad or m.")
      .field("axis", &JointAnnotation::axis, "Array of shape (3,).");
  entry<JointTask>(module, "JointTask", "An entry of `joint_tasks`; `name` is the joint.")
      .field("provider", &JointTask::provider, "Task that provides the pose of the child link.")
      .field("port", &JointTask::port, "Port of that task.")
      .field("driver", &JointTask::driver, "Task that drives the joint.");
}

void bind_mechanisms(py::module_& module) {
  entry<JointPoseSet>(module, "JointPoseSet", "An entry of `poses`: named joint positions.")
      .attribute(
          "positions",
          [](const Ref<JointPoseSet>& self) {
            py::dict positions;
            for (const JointPoseSet::Entry& one : self->joints) {
              if (one.position) positions[to_text(one.name.value)] = *one.position;
            }
            return positions;
          },
          "A dict from motors or joints, as written, to positions, rad or m. "
          "Model.joint_positions() names joints only.");
  entry<Submechanism>(module, "Submechanism", "An entry of `submechanisms`.")
      .field("contextual_name", &Submechanism::contextual_name,
             "Name of this mechanism in the robot.")
      .field("type", &Submechanism::type, "Type.")
      .field("joint_names", &Submechanism::joint_names, "All joints.")
      .field("joint_names_spanning_tree", &Submechanism::joint_names_spanning_tree, "Joints.")
      .field("joint_names_active", &Submechanism::joint_names_active, "Joints.")
      .field("joint_names_independent", &Submechanism::joint_names_independent, "Joints.");
  entry<Exoskeleton>(module, "Exoskeleton", "An entry of `exoskeletons`.")
      .field("contextual_name", &Exoskeleton::contextual_name,
             "Name of this mechanism in the robot.")
      .field("around", &Exoskeleton::around, "Part of the human.")
      .field("joint_names", &Exoskeleton::joint_names, "All joints.")
      .field("joint_names_spanning_tree", &Exoskeleton::joint_names_spanning_tree, "Joints.")
      .field("joint_names_dependent", &Exoskeleton::joint_names_dependent, "Joints.");
  entry<Interface>(module, "Interface", "An entry of `interfaces`.")
      .field("parent", &Interface::parent, "Link.")
      .field("type", &Interface::type, "Type.")
      .field("direction", &Interface::direction, "Direction.")
      .field("position", &Interface::position, "In the parent link: array of shape (3,), m.")
      .field(
          "rotation", &Interface::rotation,
          "In the parent link: roll, pitch, yaw about its fixed axes, array of shape (3,), rad.");
  entry<Submodel>(module, "Submodel", "An entry of `submodels`.")
      .field("export_directory", &Submodel::export_directory, "Folder.")
      .field("start", &Submodel::start, "Root link.")
      .field("stop", &Submodel::stop, "Links at which it ends.");
}

void bind_display(py::module_& module) {
  entry<Light>(module, "Light", "An entry of `lights`, in the world.")
      .field("position", &Light::position, "Array of shape (3,), m.")
      .field("look_at", &Light::look_at, "Array of shape (3,), m.")
      .field("ambient", &Light::ambient, "r, g, b, a; each 0 to 1 or None.")
      .field("diffuse", &Light::diffuse, "r, g, b, a; each 0 to 1 or None.")
      .field("specular", &Light::specular, "r, g, b, a; each 0 to 1 or None.")
      .field("type", &Light::type, "1 omni, 2 spot.")
      .field("angle", &Light::angle, "Of a spot, as the file has it.")
      .field("exponent", &Light::exponent, "Of a spot.")
      .field("constant_attenuation", &Light::constant_attenuation, "Attenuation.")
      .field("linear_attenuation", &Light::linear_attenuation, "Attenuation.")
      .field("quadratic_attenuation", &Light::quadratic_attenuation, "Attenuation.")
      .field("directional", &Light::directional, "Whether it shines from far away.")
      .field("node_name", &Light::node_name, "Node that it is on.");
  entry<Graphics>(module, "Graphics", "What `graphics` holds.")
      .field("clear_color", &Graphics::clear_color, "r, g, b, a; each 0 to 1 or None.")
      .field("fog_color", &Graphics::fog_color, "r, g, b, a; each 0 to 1 or None.")
      .field("fog_enabled", &Graphics::fog_enabled, "Whether there is fog.")
      .field("fog_density", &Graphics::fog_density, "Density.")
      .field("fog_start", &Graphics::fog_start, "m.")
      .field("fog_end", &Graphics::fog_end, "m.");
}

}  // namespace

void bind_annotations(py::module_& module) {
  bind_actuation(module);
  bind_elements(module);
  bind_mechanisms(module);
  bind_display(module);
}

}  // namespace smurf::python
