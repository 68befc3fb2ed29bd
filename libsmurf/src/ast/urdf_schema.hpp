// SPDX-License-Identifier: BSD-3-Clause
// The elements of URDF as one table; their attributes are rows of urdf_attributes.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/names.hpp"

namespace smurf::urdf {

/// How the value of an attribute is written.
enum class Form : std::uint8_t { number, three_numbers, four_numbers, text };

/// Whether an attribute must be present; a rule of its own reports an absent `usual` one.
enum class Need : std::uint8_t { optional, usual, required };

/// The texts are for authors of URDFs; `values`, if any, are the only allowed values.
struct AttributeSpec {
  std::string_view name;
  Need need = Need::optional;
  std::string_view doc = {};   ///< one sentence
  std::string_view unit = {};  ///< "rad or m"; may be empty
  std::string_view fallback = {};
  std::span<const std::string_view> values = {};
  NameKinds names = {};       ///< kinds of things that it may name; empty: it is not a name
  Form form = Form::number;   ///< only stated in rows without a member, whose type has the form
  std::string_view key = {};  ///< its name in the dump and in Python, if it differs
  bool is_path = false;
  bool is_last = false;  ///< in the canonical form, after the attributes of other rows

  constexpr bool is_required() const { return need == Need::required; }
  /// The name of the attribute in the dump and in Python.
  constexpr std::string_view member_name() const { return key.empty() ? name : key; }
};

struct ChildSpec {
  std::string_view name;
  bool single = false;
  bool is_usual = false;  ///< the parent is useless without it
};

struct ElementSpec {
  std::string_view name;
  std::string_view doc;  ///< one sentence
  std::span<const AttributeSpec> attributes;
  std::span<const ChildSpec> children = {};
  /// Children and attributes of vendors that some reader knows; their contents are not checked.
  std::span<const std::string_view> extensions = {};

  /// Null for a name that is not in the table.
  const AttributeSpec* attribute(std::string_view name) const;
  const ChildSpec* child(std::string_view name) const;
};

/// All elements, `robot` first.
std::span<const ElementSpec> all_element_specs();
const ElementSpec* find_element_spec(std::string_view name);
/// The known name that was probably meant: the nearest name, or the URDF name for a word of
/// SDFormat, MJCF or English (`pose`, `file`, `torque`).
std::optional<std::string_view> meant_name(std::string_view name,
                                           std::span<const std::string_view> known);

}  // namespace smurf::urdf
