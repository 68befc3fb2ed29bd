// SPDX-License-Identifier: BSD-3-Clause
// Keys of annotations as tables: one row says what a key holds, where it goes and what it means.
// The reader, the JSON schemas and the suggestions for misspelt keys are made from the same rows.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/model.hpp"

namespace smurf {

enum class ValueType : std::uint8_t {
  text,         ///< any scalar but null
  number,       ///< finite plain number
  integer,      ///< plain whole number
  boolean,      ///< true or false
  name_list,    ///< list of texts
  number_list,  ///< list of numbers
  vector3,      ///< mapping x, y, z
  vector3_list,  ///< list of three numbers
  quaternion,   ///< mapping w, x, y, z
  color,        ///< mapping r, g, b, a
  position,     ///< list of three numbers, or mapping x, y, z
  rotation,     ///< number, list of one, three or four numbers, or mapping w, x, y, z
  mapping,
  list,
  any
};

/// What a key holds. The texts go into the schema.
struct KeySpec {
  std::string_view name;
  ValueType type = ValueType::any;
  std::string_view doc = {};  ///< one sentence
  std::string_view unit = {};  ///< "rad/s"; may be empty
  std::string_view fallback = {};  ///< what MARS takes when it is absent, as JSON text; may be empty
  bool required = false;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::span<const std::string_view> choices = {};  ///< of a text; empty: any
};

template <class T>
using Member =
    std::variant<std::monostate, Field<std::string> T::*, Field<double> T::*,
                 Field<std::int64_t> T::*, Field<bool> T::*, Field<NameList> T::*,
                 Field<Vector3> T::*, Field<Color> T::*>;

/// A key and the member that keeps its value; without a member the value stays in the tree only.
template <class T>
struct Key {
  KeySpec spec;
  Member<T> member;
};

using Target = std::variant<std::monostate, Field<std::string>*, Field<double>*,
                            Field<std::int64_t>*, Field<bool>*, Field<NameList>*, Field<Vector3>*,
                            Field<Color>*>;

/// Checks one value against its row and stores it. Reports SML4001 (wrong type), SML4002 (not one of
/// the choices), SML4003 (out of range).
void read_value(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink);

/// Reports SML4004 for each required key that `mapping`, a `what` ("motor"), does not hold.
void report_missing(std::span<const KeySpec* const> missing, yaml::View mapping,
                    std::string_view what, DiagnosticSink& sink);

/// "a number", "a list of names": for messages.
std::string_view describe(ValueType type);
/// What is written there, for messages: "a list", "the text `abc`".
std::string describe(yaml::View value);

/// Reads the entry `mapping` into `out` by a table. Keys without a row are left to the tree.
template <class T>
void read_entry(std::span<const Key<T>> keys, yaml::View mapping, T& out, std::string_view what,
                DiagnosticSink& sink) {
  out.span = mapping.span();
  out.node = mapping.id();
  if (!mapping.is_mapping()) return;
  std::vector<bool> seen(keys.size(), false);
  for (const yaml::View value : mapping) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i].spec.name != value.key()) continue;
      if (seen[i]) break;  // a duplicate key is reported by the YAML reader; the first counts
      seen[i] = true;
      const Target target = std::visit(
          [&](auto member) -> Target {
            if constexpr (std::is_same_v<decltype(member), std::monostate>) {
              return std::monostate{};
            } else {
              return &(out.*member);
            }
          },
          keys[i].member);
      read_value(keys[i].spec, value, target, sink);
      break;
    }
  }
  std::vector<const KeySpec*> missing;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].spec.required && !seen[i]) missing.push_back(&keys[i].spec);
  }
  report_missing(missing, mapping, what, sink);
}

template <class T>
std::vector<const KeySpec*> specs_of(std::span<const Key<T>> keys) {
  std::vector<const KeySpec*> specs;
  for (const Key<T>& key : keys) specs.push_back(&key.spec);
  return specs;
}

}  // namespace smurf
