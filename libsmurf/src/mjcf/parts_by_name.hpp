// SPDX-License-Identifier: BSD-3-Clause
// Finds the parts of a model that sections outside of the tree name.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "mjcf/model.hpp"

namespace smurf::mjcf {

/// Refers to the model, which keeps its names. Of several parts with one name, the first.
class PartsByName {
 public:
  explicit PartsByName(const Model& model);

  // Null, or none, for no attribute and for a name that nothing has.
  const Joint* joint(const Attribute* name, const Surroundings& around) const;
  const Site* site(const Attribute* name, const Surroundings& around) const;
  std::optional<std::uint32_t> body(const Attribute* name, const Surroundings& around) const;
  const Reference* actuator(const Attribute* name, const Surroundings& around) const;

  /// The body that a joint moves.
  const Body& body_of(const Joint& joint) const { return model_.bodies[moved_.at(&joint)]; }

 private:
  template <class Part>
  using Table = std::map<std::string, Part, std::less<>>;

  const Model& model_;
  Table<const Joint*> joints_;
  Table<const Site*> sites_;
  Table<std::uint32_t> bodies_;
  Table<const Reference*> actuators_;
  std::map<const Joint*, std::uint32_t> moved_;
};

}  // namespace smurf::mjcf
