// SPDX-License-Identifier: BSD-3-Clause
// Where files that a model names may lie: a model from a stranger has no business elsewhere.
#pragma once

#include <map>
#include <span>
#include <string>

#include "smurf/file_reader.hpp"

namespace smurf {

/// Lets these files be read, with symbolic links followed before it is judged:
/// - Those in the project of each input. The project is the nearest folder around the input with
///   `.git`, `.hg` or `.svn`; without one, the folder above its package (package.xml); without
///   that, the folder two above its own (scenes name `../../models/...`).
/// - Those in the current folder, and in the packages.
/// - Configurations and ignore files in all folders above a project.
/// A shared folder is never opened as a whole. Shared are `/`, the folders directly below it unless
/// they are repositories, home folders, and all folders above a home folder. So a project ends
/// below the shared folders around it, and a shared current folder allows nothing. Where the input
/// itself lies in a shared folder, only the files beside it that are not hidden are read. Where a
/// shared folder is to be searched, only configurations and ignore files in it are read: what is
/// found is to be confined as inputs of their own.
/// What a repository keeps of itself (.git, .hg, .svn) is not part of the project, but for
/// .git/info/exclude.
/// Everything is let be read when `allow_outside`.
void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside);

/// Is this a shared folder, or a link to one?
bool is_shared_folder(const std::string& path);

}  // namespace smurf
