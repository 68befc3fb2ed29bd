// SPDX-License-Identifier: BSD-3-Clause
// The program of a tool, or of several (tools/CMakeLists.txt): the name by which it is called
// selects one of them.
#include <string_view>

#define SMURF_TOOL(name, function) int function(int argc, char** argv);
#include SMURF_TOOLS
#undef SMURF_TOOL

namespace {

struct Tool {
  std::string_view name;
  int (*function)(int argc, char** argv);
};

constexpr Tool kTools[] = {
#define SMURF_TOOL(name, function) {name, function},
#include SMURF_TOOLS
#undef SMURF_TOOL
};

}  // namespace

int main(int argc, char** argv) {
  std::string_view name = argc > 0 ? argv[0] : "";
  name.remove_prefix(name.rfind('/') + 1);
  for (const Tool& tool : kTools) {
    if (tool.name == name) return tool.function(argc, argv);
  }
  return kTools[0].function(argc, argv);
}
