// SPDX-License-Identifier: BSD-3-Clause
// The results of all checks as text and as JSON.
#pragma once

#include <span>
#include <string>

#include "smurf-load-check/check_processes.hpp"
#include "smurf/render.hpp"

namespace smurf::load_check {

struct Report {
  std::span<const Checked> checked;
  std::vector<Diagnostic> diagnostics;  ///< of all checks, finished
  const SourceMap& sources;
  Summary summary;
  bool quiet = false;
  bool all = false;
};

/// A line for each passed check, a table of stages for each other check, then the findings. `all`:
/// tables for passed checks, too; `quiet`: neither lines of passed checks nor a summary.
std::string render_text(const Report& report, const TextStyle& style);
/// The JSON of schemas/load-report.schema.json.
std::string render_json(const Report& report);

}  // namespace smurf::load_check
