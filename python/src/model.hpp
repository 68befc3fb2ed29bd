// SPDX-License-Identifier: BSD-3-Clause
// What models and scenes have in common.
#pragma once

#include <string>

#include "common.hpp"

namespace smurf::python {

/// May be called again and again.
Report check_owned(Owner& owner);
/// Raises smurf.Error when a check finds errors.
void refuse_errors(Owner& owner, const std::string& path);
/// ValueError when it is gone.
std::string current_folder();

}  // namespace smurf::python
