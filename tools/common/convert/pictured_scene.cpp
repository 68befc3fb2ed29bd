// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/pictured_scene.hpp"

#include <algorithm>
#include <utility>

#include "smurf/asset_copies.hpp"

namespace smurf::tools {
namespace {

/// Bytes. The page must be small enough to send, and for a browser to open.
constexpr std::uint64_t kMostPicture = 40'000'000;

Limits limits_of_picture(Limits limits) {
  limits.scene_bytes = std::min(limits.scene_bytes, kMostPicture);
  return limits;
}

}  // namespace

PicturedScene::PicturedScene(Session& session, const std::string& path,
                             const CheckSettings& settings, const std::string& current)
    : files_(session.files()),
      limits_(limits_of_picture(session.limits())),
      loaded_(session.load_scene(path, settings)),
      flattening_{.current_folder = current, .old_scenes = &loaded_.old_scenes} {}

PicturedScene::PicturedScene(LoadedScene loaded, const FileReader& files, const Limits& limits,
                             const std::string& current)
    : files_(files),
      limits_(limits_of_picture(limits)),
      loaded_(std::move(loaded)),
      flattening_{.current_folder = current, .old_scenes = &loaded_.old_scenes} {}

std::optional<SceneExport> PicturedScene::to_write() {
  const SourceMap& sources = *loaded_.sources;
  if (!check_scene_size(loaded_.scene, sources, flattening_, limits_, loaded_.found)) return {};
  flat_ = flatten(loaded_.scene, sources, flattening_);
  if (!check_flat_numbers(flat_, loaded_.scene, loaded_.found)) return {};
  return SceneExport{.flat = flat_,
                     .scene = loaded_.scene,
                     .sources = sources,
                     .losses = loaded_.found,
                     .meshes = mesh_source(flattening_, {}, files_, limits_),
                     .most_bytes = limits_.scene_bytes};
}

const Diagnostic* first_error(const LoadedScene& loaded) {
  const Diagnostic* first = nullptr;
  for (const Diagnostic& one : loaded.found.diagnostics()) {
    if (one.severity != Severity::error) continue;
    if (first == nullptr || (one.rule->blocks_building && !first->rule->blocks_building)) {
      first = &one;
    }
  }
  return first;
}

bool is_broken_off(const Diagnostic* error) {
  return error != nullptr && error->rule->blocks_building;
}

}  // namespace smurf::tools
