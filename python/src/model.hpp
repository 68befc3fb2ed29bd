// SPDX-License-Identifier: BSD-3-Clause
// Code that models and scenes share.
#pragma once

#include <functional>
#include <string>

#include "common.hpp"

namespace smurf::python {

/// May be called again and again.
Report check_owned(Owner& owner);
/// Raises smurf.Error when a check finds errors.
/// Raises when there is a finding that makes a result wrong.
void refuse_errors(Owner& owner, const std::string& path,
                   const std::function<bool(const Diagnostic&)>& is_loss);
/// ValueError when it is gone.
std::string current_folder();

}  // namespace smurf::python
