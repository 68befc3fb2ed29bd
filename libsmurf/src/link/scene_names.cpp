// SPDX-License-Identifier: BSD-3-Clause
#include "link/scene_names.hpp"

#include "base/suggest.hpp"

namespace smurf {

void SceneNames::add(UseIndex scope, std::string_view name, EntityIndex entity) {
  if (name.empty()) return;
  scopes_[to_size(scope)].emplace(name, entity);
  if (anywhere_.emplace(name, entity).second) names_.push_back(name);
}

std::optional<EntityIndex> SceneNames::find(UseIndex scope, std::string_view name,
                                            const LinkedScene& scene) const {
  for (std::optional<UseIndex> at = scope; at; at = scene.uses[to_size(*at)].outer) {
    const auto& names = scopes_[to_size(*at)];
    if (const auto found = names.find(name); found != names.end()) return found->second;
  }
  if (const auto found = anywhere_.find(name); found != anywhere_.end()) return found->second;
  return std::nullopt;
}

std::optional<std::string_view> SceneNames::suggest(std::string_view name) {
  if (names_.size() > comparisons_left_) return std::nullopt;
  comparisons_left_ -= names_.size();
  return nearest(name, names_);
}

} // namespace smurf
