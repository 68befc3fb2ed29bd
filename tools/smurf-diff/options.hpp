// SPDX-License-Identifier: BSD-3-Clause
// The command line of smurf-diff.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/cli/command.hpp"
#include "common/files/output.hpp"
#include "smurf/check.hpp"
#include "smurf/limits.hpp"
#include "smurf/load.hpp"

namespace smurf::tools {

inline constexpr std::string_view kSmurfDiff = "smurf-diff";

enum class DiffFormat { text, json, html };

struct Options {
  std::vector<std::string> operands;
  std::vector<XacroSettings> xacro;  ///< of each operand
  std::set<std::string> environment;
  DiffFormat format = DiffFormat::text;
  double tolerance = 1e-9;
  bool for_git = false;
  bool opens = false;  ///< a page, in the browser
  bool quiet = false;
  std::string output;
  std::string stdin_filename;
  std::map<std::string, std::string> packages;
  bool allow_outside = false;
  Limits limits;
  std::uint64_t max_seconds = kMaxSeconds;
  ColorChoice color = ColorChoice::automatic;
};

Command make_command(Options& options);
/// "robot.urdf.xacro side:=left".
std::string shown_operand(const Options& options, std::size_t index);
/// Removes a "--" that was written between --git and the operands of git.
void drop_separator(std::vector<std::string>& operands);
/// An error message about the combination of options; "" if there is none.
std::string problem_of(const Options& options);

}  // namespace smurf::tools
