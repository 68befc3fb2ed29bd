// SPDX-License-Identifier: BSD-3-Clause
// Which XML files are robots or worlds in MJCF or SDF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// Those of some files that are, without the parts of MJCF that others of them include; in the same
/// order.
std::vector<std::string> imported_robots(const std::vector<std::string>& files,
                                         const FileReader& reader, const Limits& limits);

/// The language of a text, as findings in the URDF that is made of it are marked: cases::kOfMjcf or
/// kOfSdf; null for other texts.
const Circumstance* language_of_import(std::string_view text);

}  // namespace smurf
