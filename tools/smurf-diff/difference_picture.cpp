// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/difference_picture.hpp"

#include "common/convert/pictured_scene.hpp"
#include "common/files/input.hpp"

namespace smurf::tools {

std::string picture_of(Session& session, const InputVersion& before, const InputVersion& after,
                       const Options& options) {
  if (!find_scene_format("html")->obstacle().empty()) return {};
  if (input_kind(after.path) == InputKind::annotation) return {};
  const auto current = current_folder("smurf-diff");
  if (!current) return {};
  CheckSettings settings;
  settings.packages = options.packages;
  settings.max_seconds = options.max_seconds;
  const auto scene_of = [&](const InputVersion& version) {
    settings.xacro = {version.xacro.arguments, options.environment};
    const ReplacedText replaced(session, version);
    return PicturedScene(session, version.path, settings, *current);
  };
  PicturedScene old_scene = scene_of(before);
  PicturedScene new_scene = scene_of(after);
  const std::optional<SceneExport> old_export = old_scene.to_write();
  const std::optional<SceneExport> new_export = new_scene.to_write();
  if (!old_export || !new_export) return {};
  return write_both_versions(*old_export, *new_export);
}

}  // namespace smurf::tools
