// SPDX-License-Identifier: BSD-3-Clause
#include "link/scene_names.hpp"

#include <map>

namespace smurf {

void SceneNames::add(UseIndex scope, std::string_view name, EntityIndex entity) {
  if (name.empty()) return;
  // An include has a name but is not an entity, so an entity of the same name takes precedence.
  const auto keep = [&](std::map<std::string_view, EntityIndex>& table) {
    const auto [found, is_new] = table.emplace(name, entity);
    if (std::holds_alternative<UseIndex>(found->second)) found->second = entity;
    return is_new;
  };
  keep(scopes_[to_size(scope)]);
  if (keep(anywhere_)) names_.push_back(name);
}

std::optional<EntityIndex> SceneNames::find(UseIndex scope, std::string_view name,
                                            const LinkedScene& scene) const {
  std::optional<EntityIndex> include;
  for (std::optional<UseIndex> at = scope; at; at = scene.uses[to_size(*at)].outer) {
    const auto& names = scopes_[to_size(*at)];
    const auto found = names.find(name);
    if (found == names.end()) continue;
    if (std::holds_alternative<InstanceIndex>(found->second)) return found->second;
    if (!include) include = found->second;
  }
  const auto found = anywhere_.find(name);
  if (found == anywhere_.end()) return std::nullopt;
  const bool is_instance = std::holds_alternative<InstanceIndex>(found->second);
  return is_instance || !include ? found->second : *include;
}

}  // namespace smurf
