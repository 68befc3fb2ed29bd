// SPDX-License-Identifier: BSD-3-Clause
// The files that the MoveIt Setup Assistant remembers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "smurf/companions.hpp"

namespace smurf {

/// A file that a `.setup_assistant` names.
struct SetupFile {
  yaml::NodeId relative_path{};
  std::string path;  ///< whether or not it exists
  std::string xacro_args;
};

/// The `URDF` or `SRDF` of the `.setup_assistant` at `path`; none if its package is not here.
std::optional<SetupFile> setup_file(const yaml::Document& document, std::string_view part,
                                    const std::string& path, LoadContext& context);

/// Sets `missing` of a `.setup_assistant`. A file of a package that is not found is not missing.
void find_missing_files(Companion& companion, LoadContext& context);

}  // namespace smurf
