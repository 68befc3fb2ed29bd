// SPDX-License-Identifier: BSD-3-Clause
// write(2) and rename(2) instead of streams: every error is seen, and none is reported late.
#include "common/files/output.hpp"

#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdlib>
#include <optional>
#include <thread>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/numbers/numbers.hpp"
#include "common/cli/process.hpp"
#include "common/files/file_set.hpp"
#include "plan/repository.hpp"
#include "render/printable.hpp"

namespace smurf::tools {
namespace {

/// True for "/dev/stdout", and for "/dev/fd/63", which shells write for ">(command)". These are
/// already open; opening the file again would have a different effect.
std::optional<int> open_descriptor(std::string_view path) {
  if (path == "/dev/stdout") return 1;
  if (path == "/dev/stderr") return 2;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const auto number = parse_integer(path.substr(folder.size()));
    if (number && *number >= 0 && *number <= INT_MAX) return static_cast<int>(*number);
  }
  return std::nullopt;
}

/// Writes to a device or pipe. If no program reads the pipe yet, waits at most one second.
int write_directly(const std::string& path, std::string_view text) {
  constexpr int kMoments = 100;
  constexpr std::chrono::milliseconds kMoment{10};
  Descriptor file;
  for (int i = 0; i <= kMoments && !file.is_open(); ++i) {
    if (i > 0) std::this_thread::sleep_for(kMoment);
    file.reset(sys::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (!file.is_open() && errno != ENXIO) return errno;
  }
  return file.is_open() ? write_all(file.number(), text) : ENXIO;
}

std::string reason_of(int error) {
  if (error == ENXIO) return "it is a pipe that nobody reads";
  return sys::error_text(error);
}

bool is_device_or_pipe(const std::string& path) {
  sys::Status status{};
  return sys::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
         !S_ISDIR(status.st_mode);
}

/// Returns an error message, or "".
std::string replace_file(const std::string& path, std::string_view text) {
  if (path.ends_with('/') || places::is_folder(path)) return reason_of(EISDIR);
  const std::vector<OutputFile> files{named_by_user(path, text)};
  FileSet set(files, FileSet::MissingFolders::refuse);
  const auto problem = set.write(true);
  return problem ? problem->reason : "";
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool wants_color(int descriptor) {
  if (is_set("NO_COLOR")) return false;
  if (is_set("FORCE_COLOR")) return std::string_view(std::getenv("FORCE_COLOR")) != "0";
  const char* terminal = std::getenv("TERM");
  if (terminal != nullptr && std::string_view(terminal) == "dumb") return false;
  return is_terminal(descriptor);
}

}  // namespace

void complain(std::string_view tool, std::string_view message) {
  write_error(std::string(tool) + ": " + render::escape(message) + "\n");
}

void write_error(std::string_view text) { write_all(2, text); }

OutputFile named_by_user(const std::string& path, std::string_view text) {
  const std::string place = places::canonical(path).value_or(path);
  return {std::string(path::parent(place)), std::string(path::file_name(place)), text, path};
}

bool write_output(std::string_view tool, const std::string& path, std::string_view text) {
  const bool is_standard = path.empty() || path == "-";
  const std::optional<int> open = is_standard ? 1 : open_descriptor(path);
  int error = 0;
  std::string reason;
  if (open) {
    error = write_all(*open, text);
  } else if (const auto link = link_out_of_repository(path); !link.empty()) {
    reason = reason_of_link(link);
  } else if (is_device_or_pipe(path)) {
    error = write_directly(path, text);
  } else {
    reason = replace_file(path, text);
  }
  if (error == EPIPE) return false;
  if (error != 0) reason = reason_of(error);
  if (reason.empty()) return true;
  const std::string where = is_standard ? "standard output" : "'" + path + "'";
  const std::string folder(path::parent(path));
  if (!folder.empty() && reason == reason_of(ENOENT) && !places::is_folder(folder)) {
    reason = "there is no folder '" + folder + "'";
  }
  complain(tool, "cannot write " + where + ": " + reason);
  return false;
}

TextStyle style_for(Stream stream, ColorChoice choice) {
  const int descriptor = static_cast<int>(stream);
  TextStyle style;
  style.color = choice == ColorChoice::always ||
                (choice == ColorChoice::automatic && wants_color(descriptor));
  if (const auto width = terminal_width(descriptor)) style.width = static_cast<int>(*width);
  return style;
}

}  // namespace smurf::tools
