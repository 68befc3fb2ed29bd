// SPDX-License-Identifier: BSD-3-Clause
// A scene in four steps; each reports what it finds and goes on with what is sound.
#include "base/files/path.hpp"
#include "link/imported_world.hpp"
#include "link/scene_link.hpp"
#include "smurf/xacro.hpp"

namespace smurf {
namespace {

bool is_model_file(const std::string& path) {
  const std::string extension = path::to_lower(path::extension(path));
  return extension == ".smurf" || extension == ".urdf" || extension == ".mjcf" ||
         extension == ".xml" || extension == ".sdf" || extension == ".world" ||
         xacro::is_xacro_file(path);
}

/// MARS opens a .smurf or .urdf as one entity at the origin (SMURFLoader.cpp:549-563).
void load_single_model(const std::string& path, LoadContext& context, LinkedScene& scene) {
  LinkedModel model = load_model(path, context);
  scene.is_complete = model.is_complete;
  scene.path = model.path;
  Entity entity;
  std::string name(path::stem(path));
  if (model.main.modelname) {
    name = *model.main.modelname;
  } else if (model.robot && model.robot->name) {
    name = *model.robot->name;
  }
  entity.name.set(name);
  SceneFile& file = scene.scenes.emplace_back();
  file.path = model.path;
  if (!model.files.empty()) file.source = model.files.front().source;
  entity.span = entity.head = {file.source, 0, 0};
  file.scene.entities.push_back(std::move(entity));
  scene.uses.emplace_back();
  Instance instance;
  instance.name = instance.path = name;
  instance.type = model.has_main ? "smurf" : "urdf";
  instance.file = model.path;
  instance.model = ModelIndex{0};
  instance.X_WE = Pose{};
  instance.placement.anchor = anchor_of_root(model);
  scene.instances.push_back(std::move(instance));
  scene.models.push_back(std::move(model));
}

}  // namespace

LinkedScene load_scene(const std::string& path, LoadContext& context) {
  LinkedScene scene;
  scene.schemas = context.schemas;
  if (is_model_file(path) && !is_world_file(path, context.files, context.limits)) {
    load_single_model(path, context, scene);
    return scene;
  }
  SceneNames names;
  if (!expand_scene(path, context, scene, names)) {
    scene.is_complete = false;
    return scene;
  }
  resolve_references(context, names, scene);
  resolve_joint_poses(context, scene);
  compose_world_poses(context, scene);
  return scene;
}

}  // namespace smurf
