// SPDX-License-Identifier: BSD-3-Clause
// Options that mean the same in every tool, as rows of its option table.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "common/cli/command.hpp"
#include "common/cli/report.hpp"
#include "common/files/output.hpp"
#include "smurf/limits.hpp"
#include "smurf/load.hpp"

namespace smurf::tools {

Option color_option(ColorChoice& color);
Option quiet_option(bool& quiet, std::string_view help);
/// `help` is the text for --help, which says what is written.
Option output_option(std::string& file, std::string_view help);
/// `name` is "report", or "format" where the report is the result.
Option report_option(std::string_view name, std::vector<ReportRequest>& reports);
/// --open
Option open_option(bool& opens);
Option fail_on_option(Threshold& threshold);
Option stdin_filename_option(std::string& path);
/// NAME=DIR, for package:// addresses.
Option package_option(std::map<std::string, std::string>& packages);
Option allow_outside_option(bool& allow_outside);
/// NAMES, for `$(env ...)` in xacro files.
Option xacro_env_option(std::set<std::string>& names);
/// Takes `name:=value`, an argument of a xacro file; false if it is something else.
bool take_xacro_argument(std::string_view value, XacroSettings& xacro);
/// NAME=N, for the limits on the input.
Option limit_option(Limits& limits);
/// N, for CheckSettings::max_seconds.
Option max_seconds_option(std::uint64_t& seconds);
Option jobs_option(std::optional<int>& jobs);

}  // namespace smurf::tools
