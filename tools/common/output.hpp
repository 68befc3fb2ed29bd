// SPDX-License-Identifier: BSD-3-Clause
// Standard output, standard error and files, so written that nothing is lost unnoticed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/new_model.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

/// "smurf-lint: message" on standard error. Control characters are escaped.
void complain(std::string_view tool, std::string_view message);

/// Text as it is on standard error.
void write_error(std::string_view text);

/// Writes the whole text to standard output (`path` "" or "-") or to a file, and complains if it
/// cannot; a reader that closes its end of a pipe is no news to the user, so that is not said.
/// A file is written beside its place and renamed, with the mode of the file it replaces, so that a
/// failed run leaves the old one; links are followed; devices and pipes are written directly.
bool write_output(std::string_view tool, const std::string& path, std::string_view text);

/// Makes a file in the folder of `path` under a name that is not taken, which goes to `temporary`.
/// Returns -1 with errno set when it cannot. Whoever is killed before renaming it leaves it behind.
int open_beside(const std::string& path, std::string& temporary);

/// Writes to an open file and closes it; 0 or an errno. A full disk may be noticed as late as at
/// the end.
int write_and_close(int descriptor, std::string_view text, bool sync);

/// Writes all files or none, and complains if it cannot. Paths start from `folder`; folders that
/// are missing are made. Existing files are an error unless `overwrite`.
bool write_files(std::string_view tool, const std::string& folder,
                 const std::vector<TextFile>& files, bool overwrite);

enum class ColorChoice { automatic, always, never };

enum class Stream : int { output = 1, error = 2 };

/// How text for a person is to look there. Automatic colour: NO_COLOR says no, then FORCE_COLOR
/// says yes, then TERM=dumb says no, then it takes a terminal.
TextStyle style_for(Stream stream, ColorChoice choice);

}  // namespace smurf::tools
