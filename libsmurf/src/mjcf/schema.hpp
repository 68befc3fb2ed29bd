// SPDX-License-Identifier: BSD-3-Clause
// Which elements MuJoCo knows inside of which, and their attributes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace smurf::mjcf {

/// What MuJoCo reads from the value of an attribute.
struct Value {
  enum class Kind : std::uint8_t { text, number, integer, word };
  std::string_view name;
  Kind kind = Kind::text;
  bool is_required = false;
  std::size_t least = 1, most = 1;        ///< how many numbers or integers
  std::vector<std::string_view> words{};  ///< one of them
};

/// Attributes that belong together.
struct Need {
  /// Groups of names. Of a single group, all or none are written; of several, all of at least one.
  std::vector<std::vector<std::string_view>> groups;
};

/// An element of the language where it stands: the `joint` of a body is another than that of an
/// equality.
struct Grammar {
  std::string_view name;
  char count = '*';               ///< '!' once, '?' at most once, '*' and 'R' any number
  std::vector<Value> attributes;  ///< sorted
  std::vector<Need> needs;
  std::vector<const Grammar*> children;  ///< bodies contain themselves

  const Grammar* child(std::string_view wanted) const;
  /// Null if it has no such attribute.
  const Value* attribute(std::string_view wanted) const;
};

/// Of `<mujoco>`.
const Grammar& grammar();

}  // namespace smurf::mjcf
