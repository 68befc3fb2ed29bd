// SPDX-License-Identifier: BSD-3-Clause
// Sampled states as files for other programs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "smurf-load-check/run.hpp"
#include "smurf/pose.hpp"

namespace smurf::load_check {

/// Of one check: half a million rows. A robot of 60 links is traced for 8 s in them.
inline constexpr std::size_t kMostTraceBytes = 64'000'000;

/// A name as a field of CSV.
std::string field_of(std::string_view name);

/// CSV: file, stage, time (s), link, position (m), quaternion. `file` and `link` are fields.
void append_row(std::string& rows, std::string_view file, Stage stage, double time,
                std::string_view link, const Pose& X_WL);

/// The rows of all, below their heading.
std::string render_trace(std::span<const Checked> checked);

/// SVG: energy and joint gap over time, a pair of panels for each stage.
std::string render_plot(const Checked& checked, const Bounds& bounds);

}  // namespace smurf::load_check
