// SPDX-License-Identifier: BSD-3-Clause
// Applies a checked schema to a value. The only place that knows valijson.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace smurf {

/// Where the value breaks the schema, as steps from its root, and how in valijson's words.
struct SchemaFault {
  std::vector<std::string> steps;
  std::string description;
};

class JsonSchema {
 public:
  /// `checked` comes from check_schema(). Throws std::exception when valijson refuses it.
  explicit JsonSchema(const nlohmann::json& checked);
  ~JsonSchema();

  /// None when the work or a text exceeds a bound.
  std::optional<std::vector<SchemaFault>> check(const nlohmann::json& value) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace smurf
