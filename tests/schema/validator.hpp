// SPDX-License-Identifier: BSD-3-Clause
// An independent JSON Schema validator: the Python package jsonschema, in a process of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace smurf::test {

/// One JSON text and the file of schemas/ that it is judged by.
struct Instance {
  std::string schema;
  std::string json;
};

/// One verdict an instance. None when the package is not installed; throws when a schema is not
/// valid draft-07.
std::optional<std::vector<bool>> validate(const std::vector<Instance>& instances);

}  // namespace smurf::test
