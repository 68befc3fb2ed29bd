// SPDX-License-Identifier: BSD-3-Clause
// The elements and attributes of URDF as one table.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf::urdf {

struct AttributeSpec {
  std::string_view name;
  bool required = false;
};

struct ChildSpec {
  std::string_view name;
  bool single = false;
};

struct ElementSpec {
  std::string_view name;
  std::span<const AttributeSpec> attributes;
  std::span<const ChildSpec> children;
  /// Children and attributes of vendors that some reader knows; their insides are not checked.
  std::span<const std::string_view> extensions;
};

/// Null for a name the table does not hold.
const ElementSpec* find_element_spec(std::string_view name);
/// The one of `known` that somebody most likely meant by another name: the nearest, or what
/// SDFormat, MJCF or plain English call it (`pose`, `file`, `torque`).
std::optional<std::string_view> meant_name(std::string_view name,
                                           std::span<const std::string_view> known);

}  // namespace smurf::urdf
