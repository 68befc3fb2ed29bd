// SPDX-License-Identifier: BSD-3-Clause
// Which files are loaded, and as what.
#pragma once

#include <string>
#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

struct Plan {
  std::vector<std::string> scenes;
  std::vector<std::string> models;
  std::vector<std::string> strays;  ///< .urdf and .yml files: alone, unless a model reads them
  std::string standard_input;       ///< its name in `files`; "": it was not read
  std::string config;               ///< "": none
  bool has_failed = false;          ///< something could not be read; it was said
};

/// Standard input, if it is read, goes to `files`.
Plan make_plan(const LintOptions& options, MemoryFiles& files);

}  // namespace smurf::tools
