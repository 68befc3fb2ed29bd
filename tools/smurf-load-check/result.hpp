// SPDX-License-Identifier: BSD-3-Clause
// The result of a check: stages with their figures, and diagnostics.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf::load_check {

/// Limits the trace of a run to half a million rows, which are 8 s of a robot with 60 links.
inline constexpr std::size_t kMostTraceBytes = 64'000'000;

enum class Stage : std::uint8_t { build, pose0, still, hang, drop, anchor };
inline constexpr std::array<std::string_view, 6> kStageNames = {"BUILD", "POSE0", "STILL",
                                                                "HANG",  "DROP",  "ANCHOR"};
inline std::string_view to_string(Stage stage) {
  return kStageNames[static_cast<std::size_t>(stage)];
}

/// `none`: no verdict, because the engine gave up or was stopped. `skipped`: does not apply, or an
/// earlier stage failed. Later values are worse.
enum class Verdict : std::uint8_t { pass, warn, none, fail, skipped };
inline constexpr std::array<std::string_view, 5> kVerdictNames = {"pass", "warn", "none", "fail",
                                                                  "skipped"};
inline std::string_view to_string(Verdict verdict) {
  return kVerdictNames[static_cast<std::size_t>(verdict)];
}

/// One measured number. `bound` names an entry of the table of bounds.
struct Figure {
  std::string bound;
  double value = 0;
  double limit = 0;
  std::string worst;  ///< "link `a`"; empty if the figure is zero or concerns the whole model
  Span place;         ///< where `worst` is defined

  bool is_within() const { return value <= limit; }  // false for NaN
};

struct StageResult {
  Stage stage = Stage::build;
  Verdict verdict = Verdict::pass;
  std::vector<Figure> figures;
  std::string note;  ///< description, or the reason for skipping
};

struct CheckResult {
  std::vector<StageResult> stages;
  std::vector<Diagnostic> diagnostics;
  std::string trace;          ///< rows, only if requested
  bool is_trace_cut = false;  ///< some rows did not fit
};

}  // namespace smurf::load_check
