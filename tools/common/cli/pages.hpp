// SPDX-License-Identifier: BSD-3-Clause
// Manual pages, pages of the documentation and shell completions, made from the option tables.
#pragma once

#include <string>

#include "common/cli/command.hpp"

namespace smurf::tools {

/// A page for man(1).
std::string manual_page(const Command& command);

/// The options and examples in docs/tools/NAME.md.
std::string markdown_page(const Command& command);

/// Scripts that complete options, their values, and files.
std::string bash_completion(const Command& command);
std::string zsh_completion(const Command& command);
std::string fish_completion(const Command& command);

}  // namespace smurf::tools
