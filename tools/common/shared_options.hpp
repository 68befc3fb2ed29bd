// SPDX-License-Identifier: BSD-3-Clause
// Options that mean the same in every tool, as rows of its option table.
#pragma once

#include <map>
#include <string>

#include "common/command.hpp"
#include "common/output.hpp"
#include "common/report.hpp"
#include "smurf/limits.hpp"

namespace smurf::tools {

Option color_option(ColorChoice& color);
Option quiet_option(bool& quiet, std::string_view help);
/// `help` is the text for --help, which says what is written.
Option output_option(std::string& file, std::string_view help);
/// `name` is "report", or "format" where the report is the result.
Option report_option(std::string_view name, std::vector<ReportRequest>& reports);
Option fail_on_option(Threshold& threshold);
Option stdin_filename_option(std::string& path);
/// NAME=DIR, for package:// addresses.
Option package_option(std::map<std::string, std::string>& packages);
Option allow_outside_option(bool& allow_outside);
/// NAME=N, for the limits on the input.
Option limit_option(Limits& limits);
Option jobs_option(std::optional<int>& jobs);

}  // namespace smurf::tools
