// SPDX-License-Identifier: BSD-3-Clause
// Name tables: where names are matched.
#include "smurf/linked.hpp"

#include <algorithm>
#include <bit>

#include "base/numbers/hash.hpp"

namespace smurf {
namespace {

constexpr std::size_t kSlotsForName = 2;  // fewer free slots make searches long

}  // namespace

std::size_t NameTable::slot_of(std::string_view name) const {
  const std::size_t last = slots_.size() - 1;  // sizes are powers of two
  std::size_t slot = hash_of(name) & last;
  while (slots_[slot] != 0 && names_[slots_[slot] - 1] != name) slot = (slot + 1) & last;
  return slot;
}

void NameTable::rehash(std::size_t slots) {
  slots_.assign(slots, 0);
  for (std::uint32_t i = 0; i < names_.size(); ++i) slots_[slot_of(names_[i])] = i + 1;
}

void NameTable::reserve(std::size_t count) {
  names_.reserve(count);
  indices_.reserve(count);
  // The table is never full, because a search ends at an empty slot.
  if (kSlotsForName * count >= slots_.size()) {
    rehash(std::max<std::size_t>(8, std::bit_ceil(kSlotsForName * count + 1)));
  }
}

std::optional<std::uint32_t> NameTable::add(std::string_view name, std::uint32_t index) {
  if (kSlotsForName * names_.size() >= slots_.size()) {
    rehash(std::max<std::size_t>(8, 2 * slots_.size()));
  }
  std::uint32_t& slot = slots_[slot_of(name)];
  if (slot != 0) return indices_[slot - 1];
  names_.push_back(name);
  indices_.push_back(index);
  slot = static_cast<std::uint32_t>(names_.size());
  return std::nullopt;
}

std::optional<std::uint32_t> NameTable::find(std::string_view name) const {
  const std::uint32_t found = slots_.empty() ? 0 : slots_[slot_of(name)];
  if (found == 0) return std::nullopt;
  return indices_[found - 1];
}

const NameTable* LinkedModel::names(NameKind kind) const {
  switch (kind) {
  case NameKind::motor: return &motor_names;
  case NameKind::link: return &link_names;
  case NameKind::joint: return &joint_names;
  case NameKind::visual: return &visual_names;
  case NameKind::collision: return &collision_names;
  case NameKind::material: return &material_names;
  case NameKind::sensor: return &sensor_names;
  case NameKind::node:
  case NameKind::pose:
  case NameKind::entity:
  case NameKind::group:
  case NameKind::extension: break;
  }
  return nullptr;
}

const yaml::Document* LinkedModel::document(SourceId source) const {
  for (const ModelFile& file : files) {
    if (file.source == source && file.document) return &*file.document;
  }
  return nullptr;
}

namespace {

template <class Thing>
const Thing* thing_at(const std::vector<Thing>& things, std::optional<std::uint32_t> index) {
  return index ? &things[*index] : nullptr;
}

}  // namespace

const urdf::Link* LinkedModel::find_link(std::string_view name) const {
  return robot ? thing_at(robot->links, link_names.find(name)) : nullptr;
}

const urdf::Joint* LinkedModel::find_joint(std::string_view name) const {
  return robot ? thing_at(robot->joints, joint_names.find(name)) : nullptr;
}

const Motor* LinkedModel::find_motor(std::string_view name) const {
  return thing_at(annotations.motors, motor_names.find(name));
}

const Sensor* LinkedModel::find_sensor(std::string_view name) const {
  return thing_at(annotations.sensors, sensor_names.find(name));
}

std::optional<LinkIndex> LinkedModel::link_index(std::string_view name) const {
  const auto index = link_names.find(name);
  return index ? std::optional(LinkIndex{*index}) : std::nullopt;
}

std::optional<JointIndex> LinkedModel::joint_index(std::string_view name) const {
  const auto index = joint_names.find(name);
  return index ? std::optional(JointIndex{*index}) : std::nullopt;
}

namespace {

constexpr std::pair<NameKind, std::string_view> kKinds[] = {
    {NameKind::motor, "motor"},         {NameKind::link, "link"},
    {NameKind::joint, "joint"},         {NameKind::visual, "visual"},
    {NameKind::collision, "collision"}, {NameKind::material, "material"},
    {NameKind::sensor, "sensor"},       {NameKind::node, "node"},
    {NameKind::pose, "pose"},           {NameKind::entity, "entity"},
    {NameKind::group, "group"},         {NameKind::extension, "extension"},
};

}  // namespace

std::string_view to_string(NameKind kind) { return kKinds[static_cast<std::size_t>(kind)].second; }

std::optional<NameKind> find_name_kind(std::string_view name) {
  for (const auto& [kind, word] : kKinds) {
    if (word == name) return kind;
  }
  return std::nullopt;
}

}  // namespace smurf
