// SPDX-License-Identifier: BSD-3-Clause
// Shapes of entities that are not models.
#pragma once

#include <string>
#include <vector>

#include "smurf/flatten.hpp"

namespace smurf {

/// The shape of a `primitive` or `heightmap`, from its properties; empty for other types.
/// MARS lifts a box or sphere that has no position of its own by half a metre.
std::vector<FlatShape> shapes_of(const FlatInstance& instance, bool has_position);

/// A member of an object by its key; null when there is none.
const Value* find(const Value::Object& object, std::string_view key);
/// The object that a value is; null when it is none.
const Value::Object* object_of(const Value* value);
/// The text that a value is; empty when it is none.
std::string text_of(const Value* value);
/// A number, whichever way it is written.
std::optional<double> number_of(const Value* value);

}  // namespace smurf
