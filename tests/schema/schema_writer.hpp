// SPDX-License-Identifier: BSD-3-Clause
// The JSON schemas of schemas/ that are made from the tables of keys and settings.
#pragma once

#include <map>
#include <string>

namespace smurf::test {

/// "motors.schema.json" -> its text.
std::map<std::string, std::string> write_schemas();

}  // namespace smurf::test
