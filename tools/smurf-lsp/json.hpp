// SPDX-License-Identifier: BSD-3-Clause
// Reads JSON of a client, which may contain anything. Absent or mistyped members read as empty.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace smurf::lsp {

using Json = nlohmann::json;
using Keys = std::initializer_list<const char*>;

/// The member at a path of keys, or null.
inline const Json& at(const Json& json, Keys keys) {
  static const Json kNull;
  const Json* place = &json;
  for (const char* key : keys) {
    if (!place->is_object()) return kNull;
    const auto found = place->find(key);
    if (found == place->end()) return kNull;
    place = &*found;
  }
  return *place;
}

inline std::string text_at(const Json& json, Keys keys) {
  const Json& found = at(json, keys);
  return found.is_string() ? found.get<std::string>() : std::string();
}

inline bool flag_at(const Json& json, Keys keys, bool otherwise = false) {
  const Json& found = at(json, keys);
  return found.is_boolean() ? found.get<bool>() : otherwise;
}

/// A whole number from 0 to 2^31 - 1, which is all that the protocol allows.
inline std::optional<std::uint32_t> number_at(const Json& json, Keys keys) {
  const Json& found = at(json, keys);
  if (!found.is_number_integer()) return std::nullopt;
  const auto number = found.get<std::int64_t>();
  if (number < 0 || number > 0x7fffffff) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

/// Texts of a model may be invalid UTF-8.
inline std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smurf::lsp
