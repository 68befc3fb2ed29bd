// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/annotated_colors.hpp"

namespace smurf {

std::optional<Rgba> AnnotatedColors::of(const urdf::Visual& visual, const LinkedModel& model,
                                        const FlatModel& flat) {
  const Annotations& all = model.annotations;
  if (all.materials.empty() && all.visuals.empty()) return color_of(visual, model);
  return look_of(visual, model, flat).color;
}

AnnotatedLooks::Look AnnotatedColors::look_of(const urdf::Visual& visual, const LinkedModel& model,
                                              const FlatModel& flat) {
  const Annotations& all = model.annotations;
  if (all.materials.empty() && all.visuals.empty()) {
    return {color_of(visual, model), texture_of(visual, model, flat)};
  }
  const auto [known, is_new] = known_.try_emplace(&visual);
  if (is_new) {
    known->second = looks_.try_emplace(&model, model, flat).first->second.of(visual);
  }
  return known->second;
}

}  // namespace smurf
