// SPDX-License-Identifier: BSD-3-Clause
// Which elements SDF knows inside of which, with their attributes and the kinds of their values.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace smurf::sdformat {

enum class ValueKind : std::uint8_t {
  none,
  any,  ///< not compared: the element of a plugin
  text,
  boolean,
  integer,
  unsigned_integer,
  single,  ///< a number that a float holds
  number,
  numbers2,
  numbers3,
  color,
  pose
};

struct AttributeRow {
  std::string_view name;
  bool is_required = false;
  ValueKind kind = ValueKind::text;
};

struct Grammar {
  std::string_view name;
  char count = '?';
  ValueKind kind = ValueKind::none;
  std::string_view range;  ///< of a number: "least,most", either may be absent
  std::vector<AttributeRow> attributes;
  std::vector<const Grammar*> children;

  /// Null if there is none.
  const Grammar* child(std::string_view wanted) const;
  const AttributeRow* attribute(std::string_view wanted) const;
};

/// That of `<sdf>`.
const Grammar& grammar();

}  // namespace smurf::sdformat
