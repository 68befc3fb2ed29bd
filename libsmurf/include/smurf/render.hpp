// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics and rules as text for people and as reports for programs.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

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
/// The counts by severity; the others are the caller's.
Summary summarize(std::span<const Diagnostic> diagnostics);

struct TextStyle {
  bool color = false;
  int width = 0;  ///< columns of the terminal; 0: only lines above 2000 columns are cut
};

/// Who made a report.
struct ToolName {
  std::string_view name;
  std::string_view version;
};

/// One diagnostic with source frames, labels, notes and help; ends with an empty line.
std::string render_full(const Diagnostic& diagnostic, const SourceMap& sources,
                        const TextStyle& style);
/// "path:line:col: severity[ID] message (help)" and a line end.
std::string render_concise(const Diagnostic& diagnostic, const SourceMap& sources,
                           const TextStyle& style);
/// "found 1 error and 2 warnings in 3 files (1 model)" and a line end.
std::string render_summary(const Summary& summary, const TextStyle& style);
/// One line a rule, the most frequent first: "  12  error    SML3101 unknown-joint".
std::string render_statistics(std::span<const Diagnostic> diagnostics, const TextStyle& style);
/// The JSON report of schemas/lint-report.schema.json.
std::string render_json(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, const ToolName& tool);

/// The page of one rule, for `--explain`.
std::string render_rule(const Rule& rule, const TextStyle& style);
/// One line a rule, for `--list-rules`.
std::string render_rule_list(std::span<const Rule* const> rules, const TextStyle& style);
/// A JSON array of all that the rules say about themselves.
std::string render_rule_list_json(std::span<const Rule* const> rules);

}  // namespace smurf
