// SPDX-License-Identifier: BSD-3-Clause
// Applies a checked schema to a value. This is the only place that uses valijson.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "schema/checked_schema.hpp"

namespace smurf {

/// Where the value violates the schema, as steps from its root, and the message of valijson.
struct SchemaFault {
  std::vector<std::string> steps;
  std::string description;
};

class JsonSchema {
 public:
  /// Throws std::exception when valijson refuses the schema.
  explicit JsonSchema(CheckedSchema checked);
  ~JsonSchema();

  /// Subtracts its cost from the steps. If they do not suffice, returns none and sets them to 0.
  std::optional<std::vector<SchemaFault>> check(const nlohmann::json& value,
                                                std::int64_t& steps_left) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace smurf
