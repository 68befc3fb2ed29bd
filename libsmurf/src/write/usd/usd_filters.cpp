// SPDX-License-Identifier: BSD-3-Clause
#include "write/usd/usd_filters.hpp"

#include <vector>

#include "base/ranges.hpp"

namespace smurf {
const UsdFilter& UsdFilters::of(const LinkedModel& model, const UsdLayout& layout,
                                std::size_t link) {
  static const UsdFilter kNone;
  const SelfCollision choice = scene_.contacts.choice;
  if (choice == SelfCollision::as_usual || choice == SelfCollision::none) return kNone;
  const auto [known, is_new] = of_model_.try_emplace(&model);
  if (is_new) known->second = find(model, layout);
  const auto found = known->second.find(link);
  return found != known->second.end() ? found->second : kNone;
}

UsdFilters::OfModel UsdFilters::find(const LinkedModel& model, const UsdLayout& layout) const {
  const auto& links = model.robot->links;
  const auto has_shapes = [&](std::size_t link) { return !links[link].collisions.empty(); };
  std::vector<bool> is_alone(links.size());  // nothing else collides in the body
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (layout.is_body(i)) is_alone[i] = !ranges::any_of(layout.frames[i], has_shapes);
  }
  OfModel filters;
  const auto pairs = scene_.contacts.left_out.find(&model);
  if (pairs == scene_.contacts.left_out.end()) return filters;
  for (const auto& [a, b] : pairs->second) {
    if (!layout.links[a] || !layout.links[b] || !has_shapes(a) || !has_shapes(b)) continue;
    if (layout.links[a]->body == layout.links[b]->body) continue;
    (is_alone[a] && is_alone[b] ? filters[a].bodies : filters[a].links).push_back(b);
  }
  return filters;
}

}  // namespace smurf
