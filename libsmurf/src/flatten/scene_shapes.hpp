// SPDX-License-Identifier: BSD-3-Clause
// Shapes of entities that are not models.
#pragma once

#include <string>
#include <vector>

#include "smurf/flatten.hpp"

namespace smurf {

/// The shape of a `primitive` or `heightmap`, from its properties; empty for other types. MARS
/// lifts a box or sphere without a position by half a metre.
std::vector<FlatShape> shapes_of(const FlatInstance& instance, bool has_position);
/// The heightmap that an entity or a node of an old scene describes; MARS calls it a terrain.
FlatHeightmap heightmap_of(const Value::Object& properties, std::string file);

/// A member of an object by its key; null if there is none.
const Value* find(const Value::Object& object, std::string_view key);
/// The value as an object; null if it is not an object.
const Value::Object* object_of(const Value* value);
/// The value as text; empty if it is not a text.
std::string text_of(const Value* value);
/// A number in any notation.
std::optional<double> number_of(const Value* value);

}  // namespace smurf
