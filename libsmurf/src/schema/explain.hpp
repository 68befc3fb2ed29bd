// SPDX-License-Identifier: BSD-3-Clause
// Turns the errors of the schema library into findings: one finding per cause, at the token at
// fault, with the description in the schema.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/json_schema.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// A finding without a rule. `schema` and `value` are the trees that the faults are about.
struct Violation {
  Span span;
  std::string message;
  std::string help;
  std::vector<std::string> notes;
  Span add_span;     ///< what a missing key would follow; may be empty
  Span schema_span;  ///< the keyword of the schema that is broken; may be empty
  std::vector<Fix> fixes;
};

/// Takes what it costs from the steps; when none are left, there may be more violations.
std::vector<Violation> explain(const std::vector<SchemaFault>& faults, yaml::View schema,
                               yaml::View value, std::int64_t& steps_left);

}  // namespace smurf
