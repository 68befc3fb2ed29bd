// SPDX-License-Identifier: BSD-3-Clause
// Findings that are no mistakes of robots which were found in a folder.
#pragma once

#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// A robot in xacro that no user named: launch files may give it other arguments.
void excuse_arguments(std::vector<Diagnostic>& found);

/// One of several robots: another one may be meant.
void excuse_one_of_several(std::vector<Diagnostic>& found);

}  // namespace smurf
