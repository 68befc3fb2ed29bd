// SPDX-License-Identifier: BSD-3-Clause
// Parts of the output of --dump-model, as described by schemas/model-dump.schema.json.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "smurf/linked.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {

/// An object with all readable contents of a model.
void print_model(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources);

/// `"links": [...], "joints": [...]` and the other parts of a URDF.
void print_robot(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources);

/// Writes a key if it has a value.
template <class V>
void print_field(JsonPrinter& json, std::string_view key, const Field<V>& field) {
  if (!field) return;
  json.key(key);
  if constexpr (std::is_same_v<V, std::string>) {
    json.text(*field);
  } else if constexpr (std::is_same_v<V, double>) {
    json.number(*field);
  } else {
    json.numbers(*field);
  }
}

/// A list of sections or keys that are in no table: name, place, value.
void print_custom(JsonPrinter& json, const std::vector<CustomSection>& sections,
                  const LinkedModel& model, const SourceMap& sources);

}  // namespace smurf
