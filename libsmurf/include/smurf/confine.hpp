// SPDX-License-Identifier: BSD-3-Clause
// Limits which files a model may name: an untrusted model must not open any other file.
#pragma once

#include <map>
#include <span>
#include <string>

#include "smurf/file_reader.hpp"

namespace smurf {

/// Allows these files to be read, judged after following symbolic links:
/// - Those in the project of each input. The project is the nearest folder around the input with
///   `.git`, `.hg` or `.svn`; without one, the folder above its package (package.xml); without
///   that, the folder two above its own (scenes name `../../models/...`).
/// - Those in the current folder, and in the packages.
/// - Configurations and ignore files in all folders above a project.
/// A shared folder is never opened as a whole. Shared are `/`, the folders directly below it unless
/// they are repositories, home folders, and all folders above a home folder. So a project ends
/// below the shared folders around it, and a shared current folder allows nothing. Where the input
/// itself lies in a shared folder, the files beside it and in its subfolders are read, except
/// hidden ones; around home folders, only those beside it. Where a shared folder is to be searched,
/// only configurations and ignore files in it are read: what is found must be confined as an input
/// of its own. The data of the repository (.git, .hg, .svn) are not part of the project, except for
/// .git/info/exclude.
/// `allow_outside` allows every file.
void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside);

/// Allows only files in the projects of the inputs, not those in the current folder or the
/// packages. Only these files may be changed by fixes and renames.
void confine_to_projects(ConfinedFiles& files, std::span<const std::string> inputs);

/// The project of an input as above; "" if the input lies in a shared folder.
std::string project_around(const std::string& input);

/// Whether the folder is a shared folder or a link to one.
bool is_shared_folder(const std::string& path);

}  // namespace smurf
