// SPDX-License-Identifier: BSD-3-Clause
// Turns violations of a schema into findings: one finding per cause, at the token at fault, with
// the description in the schema.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/json_schema.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// A violation, without a rule.
struct Violation {
  Span span;
  std::string message;
  std::string help;
  std::vector<std::string> notes;
  Span add_span;     ///< the place after which a missing key belongs; may be empty
  Span schema_span;  ///< the violated keyword of the schema; may be empty
  std::vector<Fix> fixes;
};

/// Subtracts its cost from the steps; if none remain, there may be more violations.
std::vector<Violation> explain(const std::vector<SchemaFault>& faults, std::int64_t& steps_left);

}  // namespace smurf
