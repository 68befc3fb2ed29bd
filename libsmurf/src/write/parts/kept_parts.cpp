// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/kept_parts.hpp"

#include <string_view>

#include "convert/import.hpp"
#include "convert/passes.hpp"
#include "write/parts/loops.hpp"

namespace smurf {
namespace {

class KeptFinder {
 public:
  explicit KeptFinder(const LinkedModel& model) : model_(model) {
    kept_.links.resize(model.robot->links.size());
    kept_.joints.resize(model.robot->joints.size());
  }

  KeptParts find(const SceneExport& scene) {
    for (const Sensor& sensor : model_.annotations.sensors) of_sensor(sensor);
    for (const Motor& motor : model_.annotations.motors) {
      const auto joint = motor.joint ? model_.joint_names.find(*motor.joint) : std::nullopt;
      if (joint) kept_.joints[*joint] = true;
    }
    for (const xml::ElementId id : model_.robot->extensions) {
      const xml::View element(model_.robot->document, id);
      if (element.name() == "gazebo") keep(attribute_of(element, "reference"));
    }
    for (const Loop& loop : loops_of(model_)) {
      kept_.links[loop.parent] = kept_.links[loop.child] = true;
    }
    for (const urdf::Joint& joint : model_.robot->joints) {
      if (joint.mimic && joint.mimic->joint) keep_leader(joint);
    }
    for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
      const FlatAttachment& anchor = scene.flat.instances[i].anchor;
      if (anchor.kind == Attachment::Kind::link && robot_of(scene.scene, anchor.index) == &model_)
        keep(anchor.link);
    }
    return std::move(kept_);
  }

 private:
  void keep(std::string_view name) {
    if (const auto link = model_.link_names.find(name)) kept_.links[*link] = true;
    if (const auto joint = model_.joint_names.find(name)) kept_.joints[*joint] = true;
  }

  void of_sensor(const Sensor& sensor) {
    keep(passes::gazebo_carrier(model_, sensor));
    for (const Field<std::string>* name : {&sensor.link, &sensor.joint}) {
      if (*name) keep(**name);
    }
    for (const Field<NameList>* list : {&sensor.id, &sensor.links, &sensor.joints}) {
      if (!*list) continue;
      for (const Spanned<std::string>& name : **list) keep(name.value);
    }
  }

  /// But for a screw, whose two joints are one.
  void keep_leader(const urdf::Joint& joint) {
    const auto leader = model_.joint_names.find(*joint.mimic->joint);
    if (!leader) return;
    const std::string& name = *model_.robot->joints[*leader].name;
    const bool is_screw = joint.name && *joint.name == name + "_2";
    if (!is_screw) kept_.joints[*leader] = true;
  }

  const LinkedModel& model_;
  KeptParts kept_;
};

}  // namespace

KeptParts kept_parts(const LinkedModel& model, const SceneExport& scene) {
  return KeptFinder(model).find(scene);
}

bool is_bare(const LinkedModel& model, std::size_t link, const KeptParts& kept) {
  const urdf::Link& one = model.robot->links[link];
  return !inertial_of(one) && one.visuals.empty() && one.collisions.empty() && !kept.links[link];
}

}  // namespace smurf
