// SPDX-License-Identifier: BSD-3-Clause
// Writes to standard output, standard error and files without losing anything unnoticed.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

/// "smurf-lint: message" on standard error. Control characters are escaped.
void complain(std::string_view tool, std::string_view message);

/// Text as it is on standard error.
void write_error(std::string_view text);

/// Writes the whole text to standard output (`path` "" or "-") or to a file, and complains if it
/// cannot; a reader that closes its end of a pipe is no news to the user, so that is not said.
/// A file is written beside its place and renamed, with the mode of the file it replaces, so that a
/// failed run leaves the old one. Links are followed, as the user names the file, unless one lies
/// in a repository and leads out of it. Devices and pipes are written directly; a pipe that nobody
/// reads is an error.
bool write_output(std::string_view tool, const std::string& path, std::string_view text);

/// A file that is to be written below a folder.
struct OutputFile {
  std::string folder;  ///< the user's choice: links in it are followed, as for write_output()
  std::string path;    ///< from there: made of names that others chose, so no link is followed
  std::string_view text = {};
  std::string written_as = {};  ///< what the user wrote for both, when it is one name
  /// Gives the text when it is written, so that many large files are not in memory at once.
  std::function<FileContent()> read = {};
};

/// A name for a file or folder, made of one that others chose: neither hidden nor an option, "." or
/// "..", and without '/', control characters and what means something to shells.
std::string safe_name(std::string_view name);

/// A file that the user named.
OutputFile named_by_user(const std::string& path, std::string_view text);

/// Writes all files or none, and complains if it cannot. Folders that are missing are made.
/// Existing files are an error unless `overwrite`. `last_step`, if given, is called after the files
/// are written; when it returns false (it complains itself), they are removed again.
bool write_files(std::string_view tool, const std::vector<OutputFile>& files, bool overwrite,
                 const std::function<bool()>& last_step = {});

enum class ColorChoice { automatic, always, never };

enum class Stream : int { output = 1, error = 2 };

/// How text for people looks in this place. Automatic colour: NO_COLOR says no, then FORCE_COLOR
/// says yes, then TERM=dumb says no, then it takes a terminal.
TextStyle style_for(Stream stream, ColorChoice choice);

}  // namespace smurf::tools
