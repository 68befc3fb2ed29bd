// SPDX-License-Identifier: BSD-3-Clause
// JSON, which is YAML as well, piece by piece.
#pragma once

#include <string>
#include <string_view>

#include "smurf/flatten.hpp"

namespace smurf {

/// Each appends to `out`. Bytes that are no UTF-8 become U+FFFD.
void append_json(std::string& out, std::string_view text);
void append_json(std::string& out, const Vector3& vector);
/// By components, each within [-1, 1].
void append_json(std::string& out, const Quaternion& unit);
void append_json(std::string& out, const Value& value);
void append_json(std::string& out, const Value::Object& object);
/// `"name": `, after a comma unless it is the first of its object.
void append_key(std::string& out, std::string_view name, bool is_first = false);

}  // namespace smurf
