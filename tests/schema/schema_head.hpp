// SPDX-License-Identifier: BSD-3-Clause
// What all written schemas begin with.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace smurf::test {

using Json = nlohmann::ordered_json;

inline std::string file_name(std::string_view schema) {
  return std::string(schema) + ".schema.json";
}

inline Json head(std::string_view name, std::string title, std::string_view description) {
  Json schema;
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["$id"] =
      "https://raw.githubusercontent.com/smurf-tools/smurf/main/schemas/" + file_name(name);
  schema["title"] = std::move(title);
  schema["description"] = std::string(description);
  return schema;
}

}  // namespace smurf::test
