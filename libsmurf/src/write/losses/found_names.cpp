// SPDX-License-Identifier: BSD-3-Clause
// Names that a format changes, and plug-ins that it adds.
#include "base/text/quoted.hpp"
#include "write/losses/found_things.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/sdf/sdf_model.hpp"

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

}  // namespace smurf::things
