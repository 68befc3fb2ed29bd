// SPDX-License-Identifier: BSD-3-Clause
// write(2) and rename(2) instead of streams: every error is seen, and none is reported late.
#include "common/output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/path.hpp"
#include "render/printable.hpp"

namespace smurf::tools {
namespace {

/// 0 or an errno.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) {  // someone made the shared terminal or pipe non-blocking
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
      continue;
    }
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace

int open_beside(const std::string& path, std::string& temporary) {
  const std::string folder = path.substr(0, path.size() - path::file_name(path).size());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary =
        folder + ".smurf-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

int write_and_close(int descriptor, std::string_view text, bool sync) {
  int error = write_all(descriptor, text);
  if (error == 0 && sync && ::fsync(descriptor) != 0 && errno != EINVAL) error = errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

namespace {

int write_directly(const std::string& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  return descriptor < 0 ? errno : write_and_close(descriptor, text, false);
}

int replace_file(const std::string& path, std::string_view text, std::optional<mode_t> mode) {
  std::string temporary;
  const int descriptor = open_beside(path, temporary);
  if (descriptor < 0) return errno;
  int error = 0;
  if (mode && ::fchmod(descriptor, *mode & 07777U) != 0) error = errno;
  const int written = write_and_close(descriptor, text, true);
  if (error == 0) error = written;
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) ::unlink(temporary.c_str());
  return error;
}

int write_file(const std::string& path, std::string_view text) {
  if (path.ends_with('/')) return EISDIR;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return errno == ENOENT ? replace_file(path, text, std::nullopt) : errno;
  }
  if (S_ISDIR(status.st_mode)) return EISDIR;
  if (!S_ISREG(status.st_mode)) return write_directly(path, text);
  std::error_code failed;
  const std::filesystem::path target = std::filesystem::canonical(path, failed);
  return replace_file(failed ? path : target.string(), text, status.st_mode);
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
  return ::isatty(descriptor) == 1;
}

}  // namespace

void complain(std::string_view tool, std::string_view message) {
  write_error(std::string(tool) + ": " + render::escape(message) + "\n");
}

void write_error(std::string_view text) { write_all(2, text); }

bool write_output(std::string_view tool, const std::string& path, std::string_view text) {
  const bool is_standard = path.empty() || path == "-";
  const int error = is_standard ? write_all(1, text) : write_file(path, text);
  if (error == 0) return true;
  if (error == EPIPE) return false;
  const std::string where = is_standard ? "standard output" : "'" + path + "'";
  complain(tool, "cannot write " + where + ": " + std::generic_category().message(error));
  return false;
}

TextStyle style_for(Stream stream, ColorChoice choice) {
  const int descriptor = static_cast<int>(stream);
  TextStyle style;
  style.color = choice == ColorChoice::always ||
                (choice == ColorChoice::automatic && wants_color(descriptor));
  winsize size{};
  if (::isatty(descriptor) == 1 && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0) {
    style.width = size.ws_col;
  }
  return style;
}

}  // namespace smurf::tools
