// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics as text for people and as reports for programs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Counts for the summary line and the reports.
struct Summary {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t infos = 0;
  std::size_t suppressed = 0;
  std::size_t files = 0;
  std::size_t models = 0;
  std::size_t scenes = 0;
};
Summary summarize(std::span<const Diagnostic> diagnostics);

struct TextStyle {
  bool color = false;
  int width = 0;  ///< columns of the terminal; 0: lines are never cut
};

/// One diagnostic with source frames, labels, notes and help; ends with an empty line.
std::string render_full(const Diagnostic& diagnostic, const SourceMap& sources,
                        const TextStyle& style);
/// "path:line:col: severity[ID] message (help)" and a line end.
std::string render_concise(const Diagnostic& diagnostic, const SourceMap& sources,
                           const TextStyle& style);
/// "found 1 error and 2 warnings in 3 files (1 model)"; the tool's last words.
std::string render_summary(const Summary& summary, std::span<const Diagnostic> diagnostics,
                           const TextStyle& style);
/// The JSON report of schemas/lint-report.schema.json.
std::string render_json(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, std::string_view tool);
/// The page of one rule, for `--explain`.
std::string render_rule(const Rule& rule, const TextStyle& style);

}  // namespace smurf
