// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML as JSON Schema sees them: types and equality.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "smurf/yaml.hpp"

namespace smurf {

enum class JsonType : std::uint8_t { null, boolean, number, text, list, mapping };

/// A plain scalar that YAML types as a number or boolean is one; every other scalar is a text.
JsonType json_type(yaml::View value);

/// The number of different keys.
std::size_t member_count(yaml::View mapping);

/// Whether it has the type that a schema names, such as "integer".
bool has_type(yaml::View value, std::string_view type);

/// Equal values have equal hashes. Adds the number of visited nodes.
std::size_t hash_of(yaml::View value, std::size_t& visited);

/// Equality as in JSON: numbers by value, mappings in any order. Of repeated keys, the first
/// counts. Adds the number of visited nodes.
bool are_equal(yaml::View a, yaml::View b, std::size_t& visited);

}  // namespace smurf
