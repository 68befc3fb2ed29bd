// SPDX-License-Identifier: BSD-3-Clause
// What a user reads about the formats of scenes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smurf::tools {

std::vector<std::string_view> format_names();
/// The text about --format in `--help`.
std::string format_help();
/// The text of `--format help`.
std::string formats_page();
/// Suggests the format of the program that the user named; "" if no format is for it.
std::string format_hint(std::string_view value);
/// Advice for an output file whose extension, such as ".xml", is that of no format.
std::string_view advice_on(std::string_view extension);

}  // namespace smurf::tools
