// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>

#include "base/files/path.hpp"
#include "link/imported_world.hpp"
#include "smurf/plan.hpp"

namespace smurf {

InputKind input_kind(std::string_view path) {
  const std::string extension = path::to_lower(path::extension(path));
  if (extension == ".smurf") return InputKind::model;
  if (extension == ".smurfs" || extension == ".smurfa") return InputKind::scene;
  if (extension == ".svg") return InputKind::drawing;
  if (extension == ".urdf" || extension == ".xacro") return InputKind::urdf;
  if (extension == ".mjcf" || extension == ".xml") return InputKind::urdf;
  if (extension == ".sdf" || extension == ".world") return InputKind::urdf;
  if (extension == ".yml" || extension == ".yaml" || extension == ".json") {
    return InputKind::annotation;
  }
  constexpr std::array kResources = {".stl", ".obj",  ".dae",  ".bobj", ".ply", ".gltf", ".glb",
                                     ".3ds", ".mesh", ".mtl",  ".png",  ".jpg", ".jpeg", ".bmp",
                                     ".tga", ".tif",  ".tiff", ".gif",  ".dds", ".webp", ".ktx2"};
  const bool is_resource =
      std::find(kResources.begin(), kResources.end(), extension) != kResources.end();
  return is_resource ? InputKind::resource : InputKind::other;
}

bool is_scene_file(const std::string& path, const FileReader& files, const Limits& limits) {
  const InputKind kind = input_kind(path);
  return kind == InputKind::scene || kind == InputKind::drawing ||
         is_world_file(path, files, limits);
}

}  // namespace smurf
