// SPDX-License-Identifier: BSD-3-Clause
// Names that a format changes, and plug-ins that it adds.
#include "base/text/quoted.hpp"
#include "write/losses/found_things.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/sdf/sdf_model.hpp"
#include "write/sdf/sdf_names.hpp"
#include "write/sdf/sdf_tree.hpp"

namespace smurf::things {
namespace {

/// A path with `__` for `/` is the documented form.
std::string expected_name(const FlatInstance& instance) {
  std::string name;
  for (const char c : instance.path) name += c == '/' ? "__" : std::string(1, c);
  return name;
}

}  // namespace

Found sensor_systems(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!needs_sdf_systems(model)) return found;
  found.push_back({{model.robot->document.source, 0, 0}, model.path});
  return found;
}

Found changed_names(const SceneExport& scene, SceneColumn column) {
  constexpr std::size_t kMostOfName = 240;
  Found found;
  const bool is_sdf = column == SceneColumn::sdf || column == SceneColumn::sdf16;
  const std::vector<std::string> names = is_sdf ? sdf_names(scene.flat) : safe_names(scene.flat);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const FlatInstance& instance = scene.flat.instances[i];
    const bool has_slash = instance.name.find('/') != std::string::npos;
    if (!instance.X_WE || (names[i] == expected_name(instance) && !has_slash)) continue;
    found.push_back(
        {place_of(*scene.flat.instances[i].entity),
         shortened(instance.path, kMostOfName) + " as " + shortened(names[i], kMostOfName)});
  }
  return found;
}

Found reserved_names(const SceneExport& scene, SceneColumn column) {
  constexpr std::size_t kMostOfName = 240;
  Found found;
  if (scene.form == SceneForm::reference) return found;
  const auto add = [&](Span span, const std::string& name, const std::string& written) {
    if (name == written) return;
    found.push_back(
        {span, shortened(name, kMostOfName) + " as " + shortened(written, kMostOfName)});
  };
  for (const LinkedModel& model : scene.scene.models) {
    if (!model.robot || model.tree.roots.empty()) continue;
    const SdfTree tree = sdf_tree(model, kept_parts(model, scene));
    const bool has_models = column == SceneColumn::sdf;
    const std::vector<std::string> names = sdf_names(model, has_models ? &tree.bodies : nullptr);
    const std::size_t root = to_size(model.tree.roots.front());
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i == root && tree.has_world) continue;
      add(model.robot->links[i].span, link_name(model, i), names[i]);
    }
    for (const SdfJoint& one : tree.joints) {
      if (!one.joint->name || tree.bodies[one.frame] >= names.size()) continue;
      const std::string& name = *one.joint->name;
      const bool is_nested =
          tree.bodies[one.parent] < names.size() &&
          !sdf_joint_scope(name, names[tree.bodies[one.parent]], names[tree.bodies[one.frame]])
               .empty();
      if (!is_nested) add(one.joint->span, name, sdf_name(name));
    }
  }
  return found;
}

}  // namespace smurf::things
