// SPDX-License-Identifier: BSD-3-Clause
// A user's JSON Schema, made safe: what it may not hold is reported at its place, and what is left
// can be applied to any data without endless recursion.
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

/// What a subschema needs to be safe to apply.
struct SchemaGuard {
  std::optional<Pattern> pattern{};  ///< the keyword `pattern`, which is hidden from the library
  std::int64_t steps = 1;            ///< cost of applying the subschema, in steps of about 1 us
  bool has_name_patterns = false;
  bool has_unique_items = false;
};

/// What it takes to read a pattern of names again, which the library does for every mapping.
inline constexpr std::int64_t kStepsForNamePattern = 100;

/// The key of every subschema that holds the index of its guard.
inline constexpr const char* kGuardKey = "smurf:guard";

struct CheckedSchema {
  nlohmann::json schema;  ///< with known keywords only
  std::vector<SchemaGuard> guards;
};

/// At most this many values with aliases followed; more are not turned into JSON.
inline constexpr std::size_t kLargest = 200000;
/// The values that it holds, itself included; counted no further than one above kLargest.
std::size_t size_of(yaml::View value);

/// The value with this key, or at this index; null when there is none.
yaml::View child(yaml::View parent, std::string_view step);

/// The value as JSON; numbers without fraction are integers. Repeated keys keep the first value.
nlohmann::json to_json(yaml::View value);

/// None, and SML9011 reported, when the schema is broken.
std::optional<CheckedSchema> check_schema(yaml::View root, DiagnosticSink& sink);

/// The node that "#/definitions/color" names; null when there is none or it is in another file.
yaml::View follow_reference(yaml::View root, std::string_view reference);

}  // namespace smurf
