// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/findings_picture.hpp"

#include <optional>

#include "common/convert/pictured_scene.hpp"
#include "common/files/input.hpp"
#include "smurf-lint/settings.hpp"

namespace smurf::tools {
namespace {

/// The only scene, otherwise the only model, otherwise the only URDF; null if there are none or
/// several.
const PlannedFile* only_one(const Plan& plan) {
  if (plan.scenes.size() == 1) return &plan.scenes.front();
  if (!plan.scenes.empty()) return nullptr;
  if (plan.models.size() == 1) return &plan.models.front();
  if (!plan.models.empty()) return nullptr;
  const PlannedFile* found = nullptr;
  for (const PlannedFile& file : plan.others) {
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
  PicturedScene scene(session, shown->path, check_settings(options), *current);
  const std::optional<SceneExport> to_write = scene.to_write();
  if (!to_write) return {};
  std::string page = format.write(*to_write);
  if (page.size() > to_write->most_bytes) page.clear();
  return page;
}

}  // namespace smurf::tools
