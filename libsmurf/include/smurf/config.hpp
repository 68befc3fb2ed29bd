// SPDX-License-Identifier: BSD-3-Clause
// The configuration file of smurf-lint.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/lint.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

inline constexpr std::string_view kConfigName = ".smurf-lint.yaml";

/// What a configuration file says; what it does not say is empty.
struct Config {
  RuleSelection selection;
  UserSchemas schemas;
  std::vector<std::string> targets;  ///< readers to be checked for, as written
};

/// Reads a configuration with the schemas it names, whose paths are relative to it. Everything
/// wrong is reported at its place (SML90xx); the rest counts.
Config read_config(const std::string& path, SourceMap& sources, const FileReader& files,
                   DiagnosticSink& sink);

}  // namespace smurf
