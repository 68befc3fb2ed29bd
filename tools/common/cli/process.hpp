// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace smurf::tools {

/// Call it at the start of main. A closed pipe and a limit on file sizes then fail a write instead
/// of killing the process; files cannot replace closed standard streams; memory comes in large
/// pages where possible; and the run ends with kFailed when memory is exhausted.
void prepare_process();

/// The arguments of this process, the name of the program first.
std::vector<std::string> arguments_of(int argc, const char* const* argv);

bool is_terminal(int descriptor);
/// In columns; none if it is not a terminal.
std::optional<std::size_t> terminal_width(int descriptor);

}  // namespace smurf::tools
