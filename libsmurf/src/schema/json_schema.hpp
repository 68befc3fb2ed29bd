// SPDX-License-Identifier: BSD-3-Clause
// Applies a checked schema to a value. The only place that knows valijson.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "schema/checked_schema.hpp"

namespace smurf {

/// Where the value breaks the schema, as steps from its root, and how in valijson's words.
struct SchemaFault {
  std::vector<std::string> steps;
  std::string description;
};

class JsonSchema {
 public:
  /// Throws std::exception when valijson refuses the schema.
  explicit JsonSchema(CheckedSchema checked);
  ~JsonSchema();

  /// Takes what it costs from the steps. None when they do not suffice; none are left then.
  std::optional<std::vector<SchemaFault>> check(const nlohmann::json& value,
                                                std::int64_t& steps_left) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace smurf
