// SPDX-License-Identifier: BSD-3-Clause
// --joint-order: the orders of joints and bodies that readers build.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// The result refers to `options`.
Option joint_order_option(LintOptions& options);

/// Writes a table or JSON. Errors go to standard error.
ExitCode show_joint_orders(const LintOptions& options);

}  // namespace smurf::tools
