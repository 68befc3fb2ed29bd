// SPDX-License-Identifier: BSD-3-Clause
// The JSON schemas of schemas/ that are made from the tables of keys and settings.
#pragma once

#include <map>
#include <string>

#include "schema/schema_head.hpp"

namespace smurf::test {

/// A schema in the layout of the files.
std::string to_text(const Json& schema);

/// "motors.schema.json" -> its text.
std::map<std::string, std::string> write_schemas();

}  // namespace smurf::test
