// SPDX-License-Identifier: BSD-3-Clause
// The parts of the JSON report, which the page of findings shows as well.
#pragma once

#include <span>

#include "render/json_text.hpp"
#include "smurf/render.hpp"

namespace smurf::render {

/// The report with an empty list of diagnostics.
Json report_json(const SourceMap& sources, const Summary& summary, const ToolName& tool,
                 std::span<const TargetVerdict> targets);
Json diagnostic_json(const Diagnostic& diagnostic, const SourceMap& sources);
Json rule_json(const Rule& rule);

}  // namespace smurf::render
