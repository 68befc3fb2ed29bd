// SPDX-License-Identifier: BSD-3-Clause
// --dump-model: what is read of a model or scene, for programs.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Writes options.dump_model as JSON (schemas/model-dump.schema.json). What reading it finds goes
/// to standard error and decides the exit code; the rules are not run.
ExitCode dump_model(const LintOptions& options);

}  // namespace smurf::tools
