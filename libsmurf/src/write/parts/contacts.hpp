// SPDX-License-Identifier: BSD-3-Clause
// The contact settings of a shape in SMURF. Two shapes collide when their bitmasks share a bit.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "smurf/flatten.hpp"

namespace smurf {

struct Contacts {
  std::optional<std::int64_t> bitmask;
  std::optional<double> friction1, friction2;
};

/// Keys of a primitive.
Contacts contacts_of(const Value::Object& properties);

/// The annotations of a model's collisions, by name.
class CollisionContacts {
 public:
  explicit CollisionContacts(const LinkedModel& model);
  Contacts of(const urdf::Collision& collision, const urdf::Link& link) const;

 private:
  const LinkedModel* model_;
  std::map<std::string_view, const CollisionAnnotation*> annotations_;
};

}  // namespace smurf
