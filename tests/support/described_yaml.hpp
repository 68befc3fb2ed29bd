// SPDX-License-Identifier: BSD-3-Clause
// Everything that is read of a YAML text, as a text to compare.
#pragma once

#include <string>

#include "syntax/yaml_reader.hpp"

namespace smurf::test {

/// A line a diagnostic, then a line a node with all its members.
std::string described_yaml(YamlEngine engine, const std::string& text);

}  // namespace smurf::test
