// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/parts_by_name.hpp"

namespace smurf::mjcf {
namespace {

/// A pointer to what the table has for a name; null if it has nothing.
template <class Table>
const typename Table::mapped_type* find(const Table& table, const Attribute* name,
                                        const Surroundings& around) {
  if (name == nullptr) return nullptr;
  const auto found = table.find(full_name(name->value(), around));
  return found == table.end() ? nullptr : &found->second;
}

}  // namespace

PartsByName::PartsByName(const Model& model) : model_(model) {
  for (std::uint32_t i = 0; i < model.bodies.size(); ++i) {
    bodies_.emplace(model.bodies[i].name, i);
    for (const Joint& joint : model.bodies[i].joints) {
      joints_.emplace(joint.name, &joint);
      moved_.emplace(&joint, i);
    }
  }
  for (const Site& site : model.sites) sites_.emplace(site.name, &site);
  for (const Reference& one : model.sections) {
    const Attribute* name = one.element.attribute("name");
    if (one.section != "actuator" || name == nullptr) continue;
    actuators_.emplace(full_name(name->value(), one.around), &one);
  }
}

const Joint* PartsByName::joint(const Attribute* name, const Surroundings& around) const {
  const auto* found = find(joints_, name, around);
  return found == nullptr ? nullptr : *found;
}

const Site* PartsByName::site(const Attribute* name, const Surroundings& around) const {
  const auto* found = find(sites_, name, around);
  return found == nullptr ? nullptr : *found;
}

std::optional<std::uint32_t> PartsByName::body(const Attribute* name,
                                               const Surroundings& around) const {
  const auto* found = find(bodies_, name, around);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

const Reference* PartsByName::actuator(const Attribute* name, const Surroundings& around) const {
  const auto* found = find(actuators_, name, around);
  return found == nullptr ? nullptr : *found;
}

}  // namespace smurf::mjcf
