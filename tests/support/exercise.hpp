// SPDX-License-Identifier: BSD-3-Clause
// Runs everything that the library does with a path, and checks its promises for any input.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/source.hpp"

namespace smurf::test {

struct Exercise {
  std::size_t findings = 0;
  bool has_errors = false;
  std::set<std::string> unreadable{};  ///< files with an SML00xx
  std::vector<std::string> broken{};   ///< violated promises, in words; empty if there are none
  std::vector<std::pair<std::string, std::string>> fixed{};  ///< path and text after all fixes
};

struct ExerciseOptions {
  bool renders = true;    ///< write reports of all findings
  bool converts = false;  ///< export and flatten accepted files; urdfdom checks the result
  bool fixes = false;     ///< apply every fix
};

/// Every finding must lie in its file and have a message.
void check_findings(const std::vector<Diagnostic>& findings, const SourceMap& sources,
                    Exercise& result);

Exercise exercise(const FileReader& files, const std::string& path,
                  const ExerciseOptions& options = {});

}  // namespace smurf::test
