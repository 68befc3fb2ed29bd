// SPDX-License-Identifier: BSD-3-Clause
// Findings that are no mistakes of robots which were found in a folder.
#pragma once

#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A robot in xacro that no user named: launch files may give it other arguments.
void excuse_arguments(std::vector<Diagnostic>& found);

/// One of several robots: another one may be meant.
void excuse_one_of_several(std::vector<Diagnostic>& found);

/// Whether a xacro file is only a part of robots, because it makes no link, or needs values that
/// others set. Robots have a name; `was_found` means that no user named the file.
bool is_part(const LinkedModel& model, const SourceMap& sources, bool was_found);

}  // namespace smurf
