// SPDX-License-Identifier: BSD-3-Clause
// JSON, which is YAML as well, piece by piece.
#pragma once

#include <string>
#include <string_view>

#include "smurf/flatten.hpp"

namespace smurf {

/// Each function appends to `out`. Invalid UTF-8 becomes U+FFFD.
void append_json(std::string& out, std::string_view text);
void append_json(std::string& out, const Vector3& vector);
/// Each component is clamped to [-1, 1].
void append_json(std::string& out, const Quaternion& unit);
void append_json(std::string& out, const Value& value);
void append_json(std::string& out, const Value::Object& object);
/// `"name": `, after a comma unless it is the first of its object.
void append_key(std::string& out, std::string_view name, bool is_first = false);

}  // namespace smurf
