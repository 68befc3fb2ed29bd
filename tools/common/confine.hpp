// SPDX-License-Identifier: BSD-3-Clause
// Where files that a model names may lie: a model from a stranger has no business elsewhere.
#pragma once

#include <map>
#include <span>
#include <string>

#include "common/command.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

Option allow_outside_option(bool& allow_outside);

/// Lets these files be read: those of the current folder; of the project around each input, which
/// is its repository, else the folder above its package, else two folders above its own (scenes
/// name `../../models/...`); of the packages; and configurations and ignore files in all folders
/// above. Everything when `allow_outside`.
void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside);

}  // namespace smurf::tools
