// SPDX-License-Identifier: BSD-3-Clause
// Runs everything that the library does with a path, and checks its promises for any input.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"

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

Exercise exercise(const FileReader& files, const std::string& path,
                  const ExerciseOptions& options = {});

}  // namespace smurf::test
