// SPDX-License-Identifier: BSD-3-Clause
// Everything that the library does with a path, and what it promises of any input.
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
  std::vector<std::string> broken{};   ///< promises, in words; empty when all hold
  std::vector<std::pair<std::string, std::string>> fixed{};  ///< path and text, all fixes applied
};

struct ExerciseOptions {
  bool renders = true;    ///< reports of all findings are written
  bool converts = false;  ///< what is accepted is exported and flattened; urdfdom judges
  bool fixes = false;     ///< every fix is applied
};

Exercise exercise(const FileReader& files, const std::string& path,
                  const ExerciseOptions& options = {});

}  // namespace smurf::test
