// SPDX-License-Identifier: BSD-3-Clause
// Misspelt names in companions of robots that cannot be expanded: compared with what the files of
// the robot write.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "plan/companion_robots.hpp"
#include "smurf/companions.hpp"
#include "smurf/diagnostic.hpp"

namespace smurf {

/// Names in a companion that are misspellings of names in the text of a robot.
struct MisspeltNames {
  std::string robot;  ///< its path; "" if nothing is misspelt
  std::set<std::string, std::less<>> names;
  /// The joints and links that the text of the robot writes.
  std::vector<std::string> known;
};

/// Compares with the robots at these paths, none of which could be expanded. Nothing is misspelt if
/// a robot of the project writes the name, or if one of the other names is unknown: the file may
/// then be for other arguments.
MisspeltNames find_misspelt(const std::string& companion, const SeenCompanion& seen,
                            const std::vector<std::string>& robots, CompanionRobots& texts);

/// Reports these names in the companion, each once.
void report_written(const Companion& companion, const MisspeltNames& misspelt,
                    DiagnosticSink& sink);

}  // namespace smurf
