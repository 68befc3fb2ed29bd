// SPDX-License-Identifier: BSD-3-Clause
// Shows pages in the browser of the user.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smurf::tools {

/// Starts the program that opens files and addresses on this system, without a shell; "" or the
/// reason why that failed. `target` is an absolute path or an address.
std::string open_for_user(const std::string& target);

/// Where the user keeps temporary files.
std::string temporary_folder();

/// Writes a page to a new file in the temporary folder that only the user can read. `stem` is the
/// name of what it shows. Returns the path; reports an error and returns "" if that fails.
std::string write_temporary_page(std::string_view tool, std::string_view stem,
                                 std::string_view text);

/// Opens a written page, or reports why not, with its address; whether it was opened.
bool show_page(std::string_view tool, const std::string& target);

}  // namespace smurf::tools
