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

/// The shading of an effect; null if there is none.
View shading_of(View effect) {
  const View technique = descend(effect, {"profile_COMMON", "technique"});
  for (const std::string_view shading : {"phong", "lambert", "blinn"}) {
    const View found = descend(technique, {shading});
    if (found && found.child("diffuse")) return found;
  }
  return {};
}

/// How COLLADA 1.4.1 defines the opacity. Exporters that invert it write what would be invisible.
double opacity_of(View shading) {
  const View transparent = shading.child("transparent");
  const View share = descend(shading, {"transparency", "float"});
  if (!transparent && !share) return 1;
  const auto numbers_in = [](View element) {
    std::vector<double> all = element ? numbers(element.text()) : std::vector<double>();
    return is_finite(all) ? all : std::vector<double>();
  };
  const std::vector<double> given = numbers_in(share);
  const double factor = given.size() == 1 ? given.front() : 1;
  std::vector<double> color = numbers_in(descend(transparent, {"color"}));
  if (color.size() != 4) color = {1, 1, 1, 1};
  const std::string_view mode = transparent ? value(transparent, "opaque") : "";
  double opacity = color[3] * factor;
  if (mode == "A_ZERO") opacity = 1 - color[3] * factor;
  if (mode == "RGB_ZERO") opacity = 1 - color[0] * factor;
  if (mode == "RGB_ONE") opacity = color[0] * factor;
  return opacity > 0 ? std::min(opacity, 1.0) : 1;
}

std::optional<Rgba> color_of(View effect) {
  const View shading = shading_of(effect);
  if (const View color = descend(shading, {"diffuse", "color"})) {
    const std::vector<double> all = numbers(color.text());
    if (all.size() < 3 || all.size() > 4 || !is_finite(all)) return std::nullopt;
    // The fourth number means nothing without <transparent>.
    Rgba rgba{0, 0, 0, opacity_of(shading)};
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
      if (descend(shading_of(effect), {"diffuse", "texture"})) has_textures_ = true;
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
