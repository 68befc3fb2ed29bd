// SPDX-License-Identifier: BSD-3-Clause
// Everything that is read from a YAML text, as a text to compare.
#pragma once

#include <string>

#include "syntax/yaml_reader.hpp"

namespace smurf::test {

/// One line per diagnostic, then one line per node with all its members.
std::string described_yaml(YamlEngine engine, const std::string& text);

}  // namespace smurf::test
