// SPDX-License-Identifier: BSD-3-Clause
// A user's JSON Schema, made safe: broken parts are reported. The rest can be applied to any data
// without endless recursion.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "schema/pattern.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// The keywords that validate. The others are dropped.
enum class Keyword : std::uint8_t {
  additional_items,
  additional_properties,
  all_of,
  any_of,
  constant,
  contains,
  dependencies,
  enumeration,
  exclusive_maximum,
  exclusive_minimum,
  if_then_else,
  items,
  max_items,
  max_length,
  max_properties,
  maximum,
  min_items,
  min_length,
  min_properties,
  minimum,
  multiple_of,
  never,  ///< the schema `false`
  not_allowed,
  one_of,
  pattern,
  pattern_properties,
  properties,
  property_names,
  reference,
  required,
  type,
  unique_items,
};

using SchemaIndex = std::uint32_t;
inline constexpr SchemaIndex kNoSchema = 0xffffffffU;

/// A keyword of a schema, ready to be applied.
struct SchemaCheck {
  Keyword keyword = Keyword::never;
  yaml::View value;  ///< as written in the schema
  double number = 0;
  /// Of a list, in its order; of a mapping, in the order of `names` or `patterns`. For
  /// if_then_else, three: kNoSchema where one is absent. For dependencies, kNoSchema where a list
  /// of names is required.
  std::vector<SchemaIndex> schemas{};
  std::vector<std::string_view> names{};  ///< of properties and dependencies, sorted
  std::vector<Pattern> patterns{};
  /// enumeration: the hash of each allowed value, sorted.
  std::vector<std::pair<std::size_t, yaml::View>> hashes{};
};

struct Subschema {
  yaml::View node;
  std::vector<SchemaCheck> checks;

  const SchemaCheck* find(Keyword keyword) const {
    for (const SchemaCheck& check : checks) {
      if (check.keyword == keyword) return &check;
    }
    return nullptr;
  }
};

struct CheckedSchema {
  std::vector<Subschema> schemas;  ///< the first is the whole schema
};

/// Limit of values, including aliases; larger ones are not checked.
inline constexpr std::size_t kLargest = 200000;
/// The number of values in it, including itself; counts only up to kLargest + 1.
std::size_t size_of(yaml::View value);

/// If the schema is broken, reports SML9011 and returns none. The result points into the document
/// of the schema.
std::optional<CheckedSchema> check_schema(yaml::View root, DiagnosticSink& sink);

}  // namespace smurf
