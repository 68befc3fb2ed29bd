// SPDX-License-Identifier: BSD-3-Clause
// Parts of what --dump-model writes, as schemas/model-dump.schema.json describes it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"
#include "write/json_printer.hpp"

namespace smurf {

/// An object with all that was read of a model.
void print_model(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources);

/// `"links": [...], "joints": [...]` and what else a URDF has.
void print_robot(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources);

/// A key that is left out when there is no value.
void print_field(JsonPrinter& json, std::string_view key, const Field<std::string>& field);
void print_field(JsonPrinter& json, std::string_view key, const Field<double>& field);
void print_field(JsonPrinter& json, std::string_view key, const Field<Vector3>& field);

/// A list of sections or keys that no table knows: name, place, value.
void print_custom(JsonPrinter& json, const std::vector<CustomSection>& sections,
                  const LinkedModel& model, const SourceMap& sources);

}  // namespace smurf
