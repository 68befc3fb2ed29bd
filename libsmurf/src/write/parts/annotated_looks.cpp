// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:333-352 and 404-426, MaterialData.cpp:47-118.
#include "write/parts/annotated_looks.hpp"

#include <algorithm>

namespace smurf {

AnnotatedLooks::AnnotatedLooks(const LinkedModel& model, const FlatModel& flat)
    : model_(model), flat_(flat), values_(model) {
  for (const MaterialAnnotation& entry : model.annotations.materials) {
    // Materials without a name are not shared.
    if (entry.name && !entry.name->empty()) annotations_.emplace(*entry.name, &entry);
  }
  for (const VisualAnnotation& entry : model.annotations.visuals) {
    if (entry.name && entry.material_name) replaced_[*entry.name] = *entry.material_name;
  }
}

AnnotatedLooks::Look AnnotatedLooks::of(const urdf::Visual& visual) const {
  Look look{color_of(visual, model_), texture_of(visual, model_, flat_)};
  std::string_view name;
  if (visual.material && visual.material->name) name = *visual.material->name;
  if (const auto other = visual.name ? replaced_.find(*visual.name) : replaced_.end();
      other != replaced_.end() && model_.material_names.contains(other->second)) {
    name = other->second;
    look = {};
    if (const urdf::Material* material = values_.definition(name)) {
      urdf::Visual as_if = visual;
      as_if.material = *material;
      look = {color_of(as_if, model_), texture_of(as_if, model_, flat_)};
    }
  }
  const auto [first, last] = annotations_.equal_range(name);
  for (auto entry = first; entry != last; ++entry) {
    const MaterialAnnotation& annotation = *entry->second;
    if (annotation.diffuse_color) look.color = visible(rgba_of(*annotation.diffuse_color));
    if (annotation.transparency && look.color) {
      (*look.color)[3] *= 1 - std::clamp(*annotation.transparency, 0.0, 1.0);
    }
    if (!annotation.diffuse_texture) continue;
    if (const auto known = flat_.annotated_textures.find(*annotation.diffuse_texture);
        known != flat_.annotated_textures.end()) {
      look.texture = known->second;
    }
  }
  return look;
}

}  // namespace smurf
