// SPDX-License-Identifier: BSD-3-Clause
// Standard output, standard error and files, so written that nothing is lost unnoticed.
#pragma once

#include <string>
#include <string_view>

#include "smurf/render.hpp"

namespace smurf::tools {

/// At the start of main: a closed pipe becomes a failed write instead of a killed process, and
/// files cannot take the place of closed standard streams.
void prepare_streams();

/// "smurf-lint: message" on standard error. Control characters are escaped.
void complain(std::string_view tool, std::string_view message);

/// Text as it is on standard error.
void write_error(std::string_view text);

/// Writes the whole text to standard output (`path` "" or "-") or to a file, and complains if it
/// cannot; a reader that closes its end of a pipe is no news to the user, so that is not said.
/// A file is written beside its place and renamed, with the mode of the file it replaces, so that a
/// failed run leaves the old one; links are followed; devices and pipes are written directly.
bool write_output(std::string_view tool, const std::string& path, std::string_view text);

enum class ColorChoice { automatic, always, never };

enum class Stream : int { output = 1, error = 2 };

/// How text for a person is to look there. Automatic colour: NO_COLOR says no, then FORCE_COLOR
/// says yes, then TERM=dumb says no, then it takes a terminal.
TextStyle style_for(Stream stream, ColorChoice choice);

}  // namespace smurf::tools
