// SPDX-License-Identifier: BSD-3-Clause
// Tools as functions, for programs that are several of them: the module of npm, and that of tests.
#pragma once

#include <string_view>

int smurf_lint_main(int argc, char** argv);
int smurf2urdf_main(int argc, char** argv);
int urdf2smurf_main(int argc, char** argv);
int smurfs_flatten_main(int argc, char** argv);

namespace smurf::tools {

using ToolMain = int (*)(int argc, char** argv);

/// Null for another name.
inline ToolMain find_tool(std::string_view name) {
  if (name == "smurf-lint") return smurf_lint_main;
  if (name == "smurf2urdf") return smurf2urdf_main;
  if (name == "urdf2smurf") return urdf2smurf_main;
  return name == "smurfs-flatten" ? smurfs_flatten_main : nullptr;
}

}  // namespace smurf::tools
