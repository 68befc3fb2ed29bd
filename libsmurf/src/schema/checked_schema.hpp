// SPDX-License-Identifier: BSD-3-Clause
// A user's JSON Schema, made safe: what it may not hold is reported at its place, and what is left
// can be applied to any data without endless recursion.
#pragma once

#include <optional>
#include <regex>
#include <string_view>

#include <nlohmann/json.hpp>

#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// The key of every subschema under which its `pattern` is kept ("" for none), so that our own
/// matcher, which cannot run away, is asked instead of the library's.
inline constexpr const char* kGuardKey = "smurf:guard";

/// libstdc++'s matcher without backtracking: its time is linear in the text, its stack constant.
inline constexpr auto kPatternSyntax =
    std::regex_constants::ECMAScript | std::regex_constants::__polynomial;

/// At most this many values with aliases followed; more are not turned into JSON.
inline constexpr std::size_t kLargest = 200000;
bool is_small(yaml::View value);

/// The value with this key, or at this index; null when there is none.
yaml::View child(yaml::View parent, std::string_view step);

/// The value as JSON; numbers without fraction are integers. Repeated keys keep the first value.
nlohmann::json to_json(yaml::View value);

/// The schema with known keywords only; none, and SML9011 reported, when it is broken.
std::optional<nlohmann::json> check_schema(yaml::View root, DiagnosticSink& sink);

/// The node that "#/definitions/color" names; null when there is none or it is in another file.
yaml::View follow_reference(yaml::View root, std::string_view reference);

}  // namespace smurf
