// SPDX-License-Identifier: BSD-3-Clause
// Sampled states as files for other programs.
#pragma once

#include <span>
#include <string>

#include "smurf-load-check/run.hpp"

namespace smurf::load_check {

/// CSV, a line for every link and step: file, stage, time (s), link, position (m), quaternion.
std::string render_trace(std::span<const Checked> checked);

/// SVG: energy and joint gap over time, a pair of panels for each stage.
std::string render_plot(const Checked& checked, const Bounds& bounds);

}  // namespace smurf::load_check
