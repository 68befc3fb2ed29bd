// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/collada_colors.hpp"

#include <algorithm>
#include <map>

namespace smurf::collada {
namespace {

using xml::View;

/// A descendant by names; null if one of them is absent.
View descend(View element, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (!element) return {};
    element = element.child(name);
  }
  return element;
}

/// The first <diffuse> of an effect; null if there is none.
View diffuse_of(View effect, std::string_view child) {
  const View technique = descend(effect, {"profile_COMMON", "technique"});
  for (const std::string_view shading : {"phong", "lambert", "blinn"}) {
    if (const View found = descend(technique, {shading, "diffuse", child})) return found;
  }
  return {};
}

std::optional<Rgba> color_of(View effect) {
  if (const View color = diffuse_of(effect, "color")) {
    const std::vector<double> all = numbers(color.text());
    if (all.size() < 3 || all.size() > 4 || !is_finite(all)) return std::nullopt;
    // The meaning of the fourth number depends on <transparent>, and exporters disagree about it.
    Rgba rgba{0, 0, 0, 1};
    for (std::size_t i = 0; i < 3; ++i) rgba[i] = std::clamp(all[i], 0.0, 1.0);
    return rgba;
  }
  return std::nullopt;
}

}  // namespace

Colors::Colors(View root) {
  std::map<std::string_view, std::optional<Rgba>> effects;
  for (const View library : root) {
    if (library.name() != "library_effects") continue;
    for (const View effect : library) {
      effects.emplace(value(effect, "id"), color_of(effect));
      if (diffuse_of(effect, "texture")) has_textures_ = true;
    }
  }
  for (const View library : root) {
    if (library.name() != "library_materials") continue;
    for (const View material : library) {
      const View instance = material.child("instance_effect");
      const auto effect = instance ? effects.find(id_in(value(instance, "url"))) : effects.end();
      if (effect != effects.end()) colors_.emplace(value(material, "id"), effect->second);
    }
  }
}

std::optional<Rgba> Colors::of(std::string_view material) const {
  const auto known = colors_.find(material);
  return known == colors_.end() ? std::nullopt : known->second;
}

Bindings bindings_of(View instance) {
  Bindings bindings;
  if (const View bound = descend(instance, {"bind_material", "technique_common"})) {
    for (const View material : bound) {
      bindings.emplace(value(material, "symbol"), id_in(value(material, "target")));
    }
  }
  return bindings;
}

}  // namespace smurf::collada
