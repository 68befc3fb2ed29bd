// SPDX-License-Identifier: BSD-3-Clause
// Sampled states as files for other programs.
#pragma once

#include <string>
#include <string_view>

#include "smurf-load-check/check_processes.hpp"
#include "smurf/pose.hpp"

namespace smurf::load_check {

/// Converts a name to a field of CSV.
std::string field_of(std::string_view name);

/// CSV: file, stage, time (s), link, position (m), quaternion. `file` and `link` are fields.
void append_row(std::string& rows, std::string_view file, Stage stage, double time,
                std::string_view link, const Pose& X_WL);

/// The header, before the rows.
inline constexpr std::string_view kTraceHeading = "file,stage,time,link,x,y,z,qw,qx,qy,qz\n";

}  // namespace smurf::load_check
