// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML files as JSON: as the tables of keys understand them, or as they are written.
#pragma once

#include <span>

#include "ast/keys.hpp"
#include "smurf/yaml.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {

/// A value without a row: scalars by the YAML 1.2 core schema, infinities and NaN as text; of equal
/// keys, the first.
void print_untyped(JsonPrinter& json, yaml::View value);

/// The keys of a mapping, in their order. Values with a row have its type: names are lists, vectors
/// [x, y, z]. Unreadable values and nulls are omitted.
void print_typed(JsonPrinter& json, yaml::View mapping, std::span<const KeySpec* const> keys);

}  // namespace smurf
