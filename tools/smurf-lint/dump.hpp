// SPDX-License-Identifier: BSD-3-Clause
// --dump-model: prints a loaded model or scene, for programs.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Writes options.dump_model as JSON (schemas/model-dump.schema.json). Findings of reading go to
/// standard error and decide the exit code; rules are not run.
ExitCode dump_model(const LintOptions& options);

}  // namespace smurf::tools
