// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/picture.hpp"

#include <algorithm>

#include "common/input.hpp"
#include "common/mesh_source.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/flatten.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {
namespace {

/// Bytes. It is a page to send, and a browser has to open it.
constexpr std::uint64_t kMostPicture = 40'000'000;

/// The one scene, else the one model, else the one URDF; null when there are none or several.
const PlannedFile* only_one(const Plan& plan) {
  if (plan.scenes.size() == 1) return &plan.scenes.front();
  if (!plan.scenes.empty()) return nullptr;
  if (plan.models.size() == 1) return &plan.models.front();
  if (!plan.models.empty()) return nullptr;
  const PlannedFile* found = nullptr;
  for (const PlannedFile& file : plan.strays) {
    if (input_kind(file.path) != InputKind::urdf) continue;
    if (found != nullptr) return nullptr;
    found = &file;
  }
  return found;
}

}  // namespace

std::string picture_of(const LintOptions& options, const LintPlan& plan, Session& session) {
  const SceneFormat& format = *find_scene_format("html");
  const PlannedFile* shown = only_one(plan);
  if (shown == nullptr || !format.obstacle().empty()) return {};
  const auto current = current_folder("smurf-lint");
  if (!current) return {};
  Limits limits = options.limits;
  limits.scene_bytes = std::min(limits.scene_bytes, kMostPicture);

  LoadedScene loaded = session.load_scene(shown->path, check_settings(options));
  const FlattenOptions flattening{.current_folder = *current, .old_scenes = &loaded.old_scenes};
  const SourceMap& sources = *loaded.sources;
  if (!check_scene_size(loaded.scene, sources, flattening, limits, loaded.found)) return {};
  const FlatScene flat = flatten(loaded.scene, sources, flattening);
  if (!check_flat_numbers(flat, loaded.scene, loaded.found)) return {};
  std::string page = format.write({.flat = flat,
                                   .scene = loaded.scene,
                                   .sources = sources,
                                   .losses = loaded.found,
                                   .meshes = mesh_source(flattening, {}, session.files(), limits),
                                   .most_bytes = limits.scene_bytes});
  if (page.size() > limits.scene_bytes) page.clear();
  return page;
}

}  // namespace smurf::tools
