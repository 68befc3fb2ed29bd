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
/// A finding without its fix.
Json finding_json(const Diagnostic& diagnostic, const SourceMap& sources);
/// A rule without the facts about readers.
Json rule_json(const Rule& rule);

}  // namespace smurf::render
