// SPDX-License-Identifier: BSD-3-Clause
// The files in folders, found as smurf-lint finds them.
#include "smurf-lint/plan.hpp"
#include "common.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/confine.hpp"

namespace smurf::python {

Plan plan_of(const std::vector<std::string>& paths, const CheckSettings& settings) {
  tools::LintOptions options;
  options.paths = paths;
  options.packages = settings.packages;
  options.xacro = settings.xacro;
  options.allow_outside = settings.allows_outside;
  options.config = settings.config;
  options.isolated = settings.is_isolated;
  ConfinedFiles disk;
  tools::confine_to_inputs(disk, options);
  const ArchiveFiles archives(disk, options.limits);
  MemoryFiles files(&archives);
  return tools::make_plan(options, files, [](const std::string&) {});
}

}  // namespace smurf::python
