// SPDX-License-Identifier: BSD-3-Clause
// Which elements MuJoCo knows inside of which, and their attributes.
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

namespace smurf::mjcf {

/// An element of the language where it stands: the `joint` of a body is another than that of an
/// equality.
struct Grammar {
  std::string_view name;
  char count = '*';                          ///< '!' once, '?' at most once, '*' and 'R' any number
  std::vector<std::string_view> attributes;  ///< sorted
  std::vector<const Grammar*> children;      ///< bodies contain themselves

  const Grammar* child(std::string_view wanted) const;
  bool has_attribute(std::string_view wanted) const;
};

/// Of `<mujoco>`.
const Grammar& grammar();

}  // namespace smurf::mjcf
