// SPDX-License-Identifier: BSD-3-Clause
// Writes to standard output, standard error and files, and reports every failure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

/// "smurf-lint: message" on standard error. Control characters are escaped.
void complain(std::string_view tool, std::string_view message);

/// Text without changes on standard error.
void write_error(std::string_view text);

/// Writes the whole text to standard output (`path` "" or "-") or to a file. Reports errors,
/// except when the reader of a pipe has closed it. A file is first written to a temporary file
/// and then renamed, with the mode of the file it replaces, so a failed run leaves the old one.
/// Links are followed, because the user names the file, unless one leads out of the repository
/// that contains it. Devices and pipes are written directly; a pipe without a reader is an
/// error.
bool write_output(std::string_view tool, const std::string& path, std::string_view text);

/// A file that a tool will write into a folder that the user chose.
struct OutputFile {
  std::string folder;  ///< chosen by the user: links in it are followed, as in write_output()
  std::string path;    ///< relative to it, with names that others chose: links are not followed
  std::string_view text = {};
  std::string written_as = {};  ///< the user's name for both, if it is a single name
  /// The text that the replaced file must still have; otherwise nothing is written.
  std::optional<std::string_view> replaces = {};
  /// Makes the text just before it is written, so that memory never holds many large files.
  std::function<FileContent()> read = {};
};

/// A file that the user named.
OutputFile named_by_user(const std::string& path, std::string_view text);

/// Writes all files or none, and reports errors. Makes missing folders. Existing files are an error
/// unless `overwrite`. `last_step`, if given, is called after the files are written; if it returns
/// false after reporting its error, they are removed again.
bool write_files(std::string_view tool, const std::vector<OutputFile>& files, bool overwrite,
                 const std::function<bool()>& last_step = {});

enum class ColorChoice { automatic, always, never };

enum class Stream : int { output = 1, error = 2 };

/// The style of text for people on this stream. Automatic colour checks in this order: NO_COLOR
/// (no), FORCE_COLOR (yes), TERM=dumb (no), and whether it is a terminal.
TextStyle style_for(Stream stream, ColorChoice choice);

}  // namespace smurf::tools
