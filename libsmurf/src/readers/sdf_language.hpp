// SPDX-License-Identifier: BSD-3-Clause
// The elements of SDF that a `gazebo` element of a URDF may contain, as one table.
#pragma once

#include <optional>
#include <string_view>

namespace smurf::sdf {

/// An attribute or a child of an element.
struct Part {
  bool is_required = false;  ///< its value must not be empty; an attribute must be there
  std::string_view name;
  /// Its value: b(ool), d(ouble), f(loat), i(nt), u(nsigned), s(tring), 2 or 3 numbers, c(olour),
  /// p(ose); '\0' when it has none.
  char value = '\0';
  std::string_view range = {};  ///< "least,most" of a number; either may be absent
  std::string_view kind = {};   ///< the row of its own parts, if any
};

/// What sdformat can refuse in an element; parts that cannot fail are left out, except in sensors.
struct Element {
  std::string_view kind;
  /// Words of the form `!name:value[least,most]@kind`.
  std::string_view attributes, children;
};

/// Null for a kind that is not in the table.
const Element* find(std::string_view kind);
/// The next part of a list at or after `at`, which becomes its end; none at the end of the list.
std::optional<Part> next_part(std::string_view list, std::size_t& at);
std::optional<Part> find_part(std::string_view list, std::string_view name);

/// True for what sdformat takes out of a `gazebo` element and translates.
bool is_translated(std::string_view name);
/// The one of them that an unknown name resembles.
std::optional<std::string_view> meant_translated(std::string_view name);

}  // namespace smurf::sdf
