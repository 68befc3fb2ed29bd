// SPDX-License-Identifier: BSD-3-Clause
// Annotations of which a format keeps only some keys.
#include "base/ranges.hpp"
#include "convert/annotation_values.hpp"
#include "write/losses/found_things.hpp"

namespace smurf::things {

Found other_keys(const LinkedModel& model, const Annotation& entry,
                 const std::vector<std::string_view>& said) {
  Found found;
  const yaml::Document* document = model.document(entry.span.source);
  if (document == nullptr) return found;
  for (const yaml::View key : yaml::View(*document, entry.node)) {
    if (key.is_null() || ranges::contains(said, key.key())) continue;
    found.push_back({key.key_span(), std::string(key.key())});
  }
  return found;
}

void append(Found& all, Found some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

Found materials(const LinkedModel& model, SceneColumn column) {
  Found found;
  std::optional<AnnotationValues> values;
  const bool is_text = column == SceneColumn::urdf || column == SceneColumn::dmd;
  if (model.robot && !is_text) values.emplace(model);
  for (const MaterialAnnotation& entry : model.annotations.materials) {
    if (!values || !values->defines(entry)) found.push_back({entry.span, entry.name.value_or({})});
  }
  return found;
}

Found material_keys(const LinkedModel& model, SceneColumn column) {
  Found found;
  if (!model.robot) return found;
  const AnnotationValues values(model);
  for (const MaterialAnnotation& entry : model.annotations.materials) {
    if (!values.defines(entry)) continue;
    std::vector<std::string_view> said{"name", "diffuseColor", "transparency"};
    if (column == SceneColumn::html || column == SceneColumn::sdf) said.push_back("diffuseTexture");
    append(found, other_keys(model, entry, said));
  }
  return found;
}

Found visual_settings(const LinkedModel& model, SceneColumn column) {
  Found found;
  for (const VisualAnnotation& entry : model.annotations.visuals) {
    if (column != SceneColumn::urdf && column != SceneColumn::dmd) {
      append(found, other_keys(model, entry, {"name", "link", "materialName"}));
    } else {
      found.push_back({entry.span, entry.name.value_or({})});
    }
  }
  return found;
}

Found link_settings(const LinkedModel& model, SceneColumn) {
  Found found;
  for (const LinkAnnotation& entry : model.annotations.links) {
    if (!other_keys(model, entry, {"name", "link", "keep_inertia"}).empty())
      found.push_back({entry.span, entry.name.value_or({})});
  }
  return found;
}

Found collision_settings(const LinkedModel& model, SceneColumn column) {
  Found found;
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (column == SceneColumn::sdf) {
      append(found,
             other_keys(model, entry, {"name", "link", "bitmask", "cfriction1", "cfriction2"}));
    } else if (column == SceneColumn::mjcf) {
      append(found, other_keys(model, entry, {"name", "link", "bitmask", "cfriction1"}));
    } else if (column == SceneColumn::usda) {
      append(found, other_keys(model, entry, {"name", "link", "cfriction1"}));
    } else {
      found.push_back({entry.span, entry.name.value_or({})});
    }
  }
  return found;
}

}  // namespace smurf::things
