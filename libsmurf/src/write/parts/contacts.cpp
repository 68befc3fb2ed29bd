// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/contacts.hpp"

#include "base/numbers/quantity.hpp"
#include "flatten/scene_shapes.hpp"

namespace smurf {

Contacts contacts_of(const Value::Object& properties) {
  Contacts contacts{.bitmask = std::nullopt,
                    .friction1 = number_of(find(properties, "cfriction1")),
                    .friction2 = number_of(find(properties, "cfriction2"))};
  for (const std::string_view key : {"coll_bitmask", "bitmask"}) {
    const Value* value = find(properties, key);
    if (value == nullptr) continue;
    if (const auto* mask = std::get_if<std::int64_t>(&value->data)) contacts.bitmask = *mask;
  }
  return contacts;
}

CollisionContacts::CollisionContacts(const LinkedModel& model) : model_(&model) {
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (entry.name) annotations_.emplace(*entry.name, &entry);
  }
}

Contacts CollisionContacts::of(const urdf::Collision& collision, const urdf::Link& link) const {
  if (!collision.name) return {};
  const auto found = annotations_.find(*collision.name);
  if (found == annotations_.end()) return {};
  const CollisionAnnotation& entry = *found->second;
  if (entry.link && *entry.link != link.name.value_or({})) return {};
  Contacts contacts{.bitmask = entry.bitmask.value(), .friction1 = {}, .friction2 = {}};
  const yaml::Document* document = model_->document(entry.span.source);
  if (document == nullptr) return contacts;
  const yaml::View keys(*document, entry.node);
  const auto quantity = [&](std::string_view key) {
    const yaml::View value = keys.find(key);
    const std::optional<double> number = value ? value.number() : std::nullopt;
    return number && is_quantity(*number) ? number : std::nullopt;
  };
  contacts.friction1 = quantity("cfriction1");
  contacts.friction2 = quantity("cfriction2");
  return contacts;
}

}  // namespace smurf
