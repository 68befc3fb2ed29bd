// SPDX-License-Identifier: BSD-3-Clause
// A user's JSON Schema, made safe: forbidden parts are reported and removed. The rest can be
// applied to any data without endless recursion.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "schema/pattern.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Data about a subschema that make it safe to apply.
struct SchemaGuard {
  std::optional<Pattern> pattern{};  ///< the keyword `pattern`, which the library does not see
  std::int64_t steps = 1;            ///< cost of applying the subschema, in steps of about 1 us
  bool has_name_patterns = false;
  bool has_unique_items = false;
};

/// The cost of compiling a pattern of names, which the library repeats for every mapping.
inline constexpr std::int64_t kStepsForNamePattern = 100;

/// The key in every subschema with the index of its guard.
inline constexpr const char* kGuardKey = "smurf:guard";

struct CheckedSchema {
  nlohmann::json schema;  ///< with known keywords only
  std::vector<SchemaGuard> guards;
};

/// Limit of values, including aliases; more are not converted to JSON.
inline constexpr std::size_t kLargest = 200000;
/// The number of values in it, including itself; counts only up to kLargest + 1.
std::size_t size_of(yaml::View value);

/// The value with this key, or at this index; null if there is none.
yaml::View child(yaml::View parent, std::string_view step);

/// The value as JSON; numbers without fraction are integers. Of repeated keys, the first is kept.
nlohmann::json to_json(yaml::View value);

/// If the schema is broken, reports SML9011 and returns none.
std::optional<CheckedSchema> check_schema(yaml::View root, DiagnosticSink& sink);

/// The node that "#/definitions/color" names; null if there is none or it is in another file.
yaml::View follow_reference(yaml::View root, std::string_view reference);

}  // namespace smurf
