// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::tools {

/// Call it at the start of main. A closed pipe and a limit on file sizes then fail a write instead
/// of killing the process; files cannot replace closed standard streams; memory comes in large
/// pages where possible; and the run ends with kFailed when memory is exhausted.
void prepare_process();

/// The arguments of this process, the name of the program first.
std::vector<std::string> arguments_of(int argc, const char* const* argv);

/// Runs another of our programs, which lies beside this one; `self` is argv[0] of this one, which
/// may have been found on the PATH. Returns its exit code, kFailed if it cannot be run; may not
/// return.
int run_beside(const std::string& self, const std::string& name,
               const std::vector<std::string>& arguments);

/// What became of another program.
struct ProgramRun {
  std::string problem;  ///< "there is no python3 on the PATH"; "": it ran to its end
  int exit_code = 0;
  int signal = 0;  ///< that ended it; 0: none
  std::string output = {};
};
/// Runs a program on the PATH with a text as its standard input, and waits until it ends. The
/// program must read the whole text before it writes; its standard error is discarded. Does
/// nothing on Windows and in WebAssembly, and says so.
ProgramRun run_program(const std::string& name, const std::vector<std::string>& arguments,
                       std::string_view input);
/// The absolute path of a program on the PATH, or "".
std::string find_program(std::string_view name);

bool is_terminal(int descriptor);
/// In columns; none if it is not a terminal.
std::optional<std::size_t> terminal_width(int descriptor);

}  // namespace smurf::tools
