// SPDX-License-Identifier: BSD-3-Clause
// Findings that are no mistakes of robots which were found in a folder.
#pragma once

#include <vector>

#include "smurf/companions.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A robot in xacro that no user named: launch files may give it other arguments.
void excuse_arguments(std::vector<Diagnostic>& found);

/// Whether a finding says that a companion names what the robot does not have.
bool is_about_name(const Diagnostic& one);

/// Names in companions that the robot lacks, because they may be for other arguments or for another
/// robot: those that files of xacro write are no findings, and others that are no misspellings are
/// infos. `may_vary`: the robot may have other arguments.
void excuse_names(const Companions& companions, const SourceMap& sources, bool may_vary,
                  std::vector<Diagnostic>& found);

/// One of several robots: another one may be meant.
void excuse_one_of_several(std::vector<Diagnostic>& found);

/// Whether a xacro file is only a part of robots, because it makes no link, or needs values that
/// others set. Robots have a name; `was_found` means that no user named the file.
bool is_part(const LinkedModel& model, const SourceMap& sources, bool was_found);

}  // namespace smurf
