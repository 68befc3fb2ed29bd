// SPDX-License-Identifier: BSD-3-Clause
// An independent JSON Schema validator: the Python package jsonschema, in a separate process.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace smurf::test {

/// A JSON text and the file in schemas/ to validate it with.
struct Instance {
  std::string schema;
  std::string json;
};

/// One verdict per instance. None if the package is not installed; throws if a schema is not valid
/// draft-07.
std::optional<std::vector<bool>> validate(const std::vector<Instance>& instances);

}  // namespace smurf::test
