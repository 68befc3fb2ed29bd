// SPDX-License-Identifier: BSD-3-Clause
// The files that `environment` names. MARS looks for most of them in the folder it is started in.
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "link/scene_link.hpp"

namespace smurf {
namespace {

struct WorldFile {
  std::string_view group, key;
  bool is_beside_scene;  ///< relative to the scene if it exists there, else to the working folder
};

constexpr WorldFile kWorldFiles[] = {
    {"skybox", "path", true},
    {"animations", "config_path", false},
    {"terrain", "path", false},
    {"terrain", "mesh", false},
};

void check_file(const WorldFile& file, yaml::View value, const std::string& scene_path,
                LoadContext& context) {
  const std::string written(value.text());
  if (written.empty() || path::is_absolute(written)) return;
  const std::string name = "`" + std::string(file.group) + "." + std::string(file.key) + "`";
  if (!file.is_beside_scene) {
    Diagnostic& diagnostic =
        context.sink.report(rules::sml5305_path_from_working_folder, value.span(),
                            "MARS looks for " + name + " in the folder where it is started");
    diagnostic.severity = Severity::info;
    return;
  }
  const std::string path = path::join(path::parent(scene_path), written);
  if (context.files.is_file(path) || !context.files.list(path).empty()) return;
  if (context.files.is_denied(path)) return;
  context.sink.report(rules::sml5305_path_from_working_folder, value.span(),
                      "there is no `" + path + "`, so MARS looks for " + name +
                          " in the folder where it is started");
}

}  // namespace

void check_world_files(const SceneFile& scene, LoadContext& context) {
  if (scene.scene.environment == yaml::kNoNode || path::extension(scene.path) == ".smurfa") return;
  const yaml::View environment(*scene.document, scene.scene.environment);
  for (const WorldFile& file : kWorldFiles) {
    const yaml::View group = environment.find(file.group);
    const yaml::View value = group && group.is_mapping() ? group.find(file.key) : yaml::View();
    if (value && value.is_scalar()) check_file(file, value, scene.path, context);
  }
}

}  // namespace smurf
