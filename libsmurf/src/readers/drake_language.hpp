// SPDX-License-Identifier: BSD-3-Clause
// One table of Drake's extensions of URDF.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace smurf::drake {

enum class Value : std::uint8_t {
  text,
  choice,  ///< "true" or "false"
  number,  ///< one
  vector,  ///< three numbers
  link,    ///< the name of a link, or `world`
  body,    ///< the name of a link other than `world`
  joint,   ///< the name of a joint that Drake makes
  frame,   ///< the name of a frame or of a link other than `world`
  group    ///< the name of a collision filter group
};

/// The range that all numbers of a value must be in.
enum class Range : std::uint8_t { all, not_negative, positive };

struct AttributeSpec {
  std::string_view name;
  Value value = Value::text;
  Range range = Range::all;
  bool is_required = true;
};

enum class Occurs : std::uint8_t {
  any,           ///< any number of times
  at_most_once,  ///< Drake reads the first one
  once,          ///< the same, and it is required
  never          ///< Drake reports an error
};

/// An element and its parent. Elements of URDF are listed with the children that Drake reads.
struct ElementSpec {
  std::string_view parent, name;
  Occurs occurs = Occurs::any;
  std::span<const AttributeSpec> attributes = {};
};

/// The elements and attributes that Drake reads in an element of this name.
std::span<const ElementSpec> children_of(std::string_view parent);

/// Whether only Drake knows an element or attribute of this name.
bool is_own_name(std::string_view name);
/// Whether a joint of this type is written `drake:joint`.
bool is_own_joint_type(std::string_view type);

}  // namespace smurf::drake
