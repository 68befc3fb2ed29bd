// SPDX-License-Identifier: BSD-3-Clause
// The elements and attributes of URDF as one table.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/names.hpp"

namespace smurf::urdf {

/// The texts are for those who write a URDF; `values` are the only ones, where there are any.
struct AttributeSpec {
  std::string_view name;
  bool required = false;
  std::string_view doc = {};   ///< one sentence
  std::string_view unit = {};  ///< "rad or m"; may be empty
  std::string_view fallback = {};
  std::span<const std::string_view> values = {};
  NameKinds names = {};   ///< what it may name; empty: nothing
  bool is_usual = false;  ///< robots need it; other rules than that on missing attributes say so
};

struct ChildSpec {
  std::string_view name;
  bool single = false;
  bool is_usual = false;  ///< the parent makes no sense without it
};

struct ElementSpec {
  std::string_view name;
  std::span<const AttributeSpec> attributes;
  std::span<const ChildSpec> children;
  /// Children and attributes of vendors that some reader knows; their insides are not checked.
  std::span<const std::string_view> extensions;
  std::string_view doc = {};  ///< one sentence
};

/// All of them, `robot` first.
std::span<const ElementSpec> all_element_specs();
/// Null for a name the table does not hold.
const ElementSpec* find_element_spec(std::string_view name);
/// The one of `known` that somebody most likely meant by another name: the nearest, or what
/// SDFormat, MJCF or plain English call it (`pose`, `file`, `torque`).
std::optional<std::string_view> meant_name(std::string_view name,
                                           std::span<const std::string_view> known);

}  // namespace smurf::urdf
