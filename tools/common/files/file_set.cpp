// SPDX-License-Identifier: BSD-3-Clause
#include "common/files/file_set.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <ctime>

#include "base/files/path.hpp"
#include "base/files/system.hpp"
#include "base/numbers/numbers.hpp"
#include "plan/repository.hpp"

namespace smurf::tools {
namespace {

constexpr const char* kInterrupted = "the run was interrupted; run it again";

#ifdef O_PATH
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;
#else
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

bool is_link(int folder, const std::string& name) {
  sys::Status status{};
  return sys::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
         S_ISLNK(status.st_mode);
}

/// Whether the opened folder differs from the judged one, because a link has replaced it. False if
/// the system cannot show this.
bool is_elsewhere(int folder, const std::string& judged) {
  const auto opened = sys::place_of(folder);
  return opened && *opened != path::normalize(judged.empty() ? "/" : judged);
}

/// Whether the file differs from the text, because another program has saved it meanwhile.
bool has_changed(int folder, const std::string& name, std::string_view text) {
  const Descriptor file(sys::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  sys::Status status{};
  if (!file.is_open() || sys::fstat(file.number(), &status) != 0 ||
      static_cast<std::uint64_t>(status.st_size) != text.size()) {
    return true;
  }
  std::array<char, 65536> buffer;
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count =
        sys::pread(file.number(), buffer.data(), buffer.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    const auto size = static_cast<std::size_t>(count);
    if (text.substr(at, size) != std::string_view(buffer.data(), size)) return true;
    at += size;
  }
  return false;
}

/// Removes files that a killed run has left in the folder: at once those of a process that has
/// ended, after a day those of another machine or container.
void remove_left_overs(int folder) {
  constexpr std::string_view kBegin = ".smurf-";
  constexpr std::string_view kEnd = ".tmp";
  constexpr std::time_t kDay = 86400;
  const int opened = sys::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  for (const std::string& name : sys::names_in(opened)) {
    if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) continue;
    const std::string_view number = std::string_view(name).substr(
        kBegin.size(), std::min(name.find('-', kBegin.size()), name.size()) - kBegin.size());
    const auto process = parse_integer(number);
    sys::Status status{};
    if (!process || *process <= 0 || *process > INT_MAX ||
        sys::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 ||
        !S_ISREG(status.st_mode)) {
      continue;
    }
    const int maker = static_cast<int>(*process);
    const std::string ours = temporary_name(maker, "");
    const bool is_ours =
        name.starts_with(std::string_view(ours).substr(0, ours.size() - kEnd.size()));
    if (is_ours ? sys::is_running(maker) : std::time(nullptr) - status.st_ctim.tv_sec < kDay) {
      continue;
    }
    sys::unlinkat(folder, name.c_str(), 0);
  }
}

FileSet::Problem changed(const std::string& path) {
  return {path, "another program has changed it meanwhile; run the command again"};
}

FileSet::Problem problem(const std::string& path, int error) {
  // The model chose these names, so following a link among them would let the model choose the
  // place.
  if (error == ELOOP) return {path, "it is a symbolic link, which is not followed here"};
  return {path, sys::error_text(error), error == EEXIST};
}

/// The reason why no file can have this path: on Windows, models could name devices. "" if one can.
std::string_view why_no_path(std::string_view path) {
  for (const std::string_view name : path::names(path)) {
    if (const auto reason = sys::why_no_name(name); !reason.empty()) return reason;
  }
  return {};
}

}  // namespace

std::string reason_of_link(const std::string& link) {
  return "`" + link + "` is a link that leads out of its repository; name the place itself";
}

FileSet::~FileSet() {
  for (Written& written : written_) {
    const int folder = written.file.folder();
    const char* const name = written.file.name().c_str();
    if (!is_done_ && written.is_placed) {
      if (written.replaces) {
        sys::renameat(folder, written.backup.c_str(), folder, name);
      } else {
        sys::unlinkat(folder, name, 0);
      }
    } else if (!written.backup.empty()) {
      sys::unlinkat(folder, written.backup.c_str(), 0);
    }
  }
  written_.clear();
  if (is_done_) return;
  for (auto made = made_folders_.rbegin(); made != made_folders_.rend(); ++made) {
    sys::unlinkat(made->first, made->second.c_str(), AT_REMOVEDIR);
  }
}

std::optional<FileSet::Problem> FileSet::write(bool overwrite) {
  if (auto found = prepare_all(overwrite)) return found;
  if (auto found = place_all(true)) return found;
  keep();
  return std::nullopt;
}

std::optional<FileSet::Problem> FileSet::write_for_now(bool overwrite) {
  if (auto found = prepare_all(overwrite)) return found;
  return place_all(false);
}

/// If `is_final`, nothing fails after the last file has its name.
std::optional<FileSet::Problem> FileSet::place_all(bool is_final) {
  for (const Written& written : written_) {
    if (written.old_text &&
        has_changed(written.file.folder(), written.file.name(), *written.old_text)) {
      return changed(written.shown);
    }
  }
  for (Written& written : written_) {
    if (signals_.has_one()) return Problem{written.shown, kInterrupted};
    const bool is_last = is_final && &written == &written_.back();
    if (auto found = place(written, is_last)) return found;
  }
  return std::nullopt;
}

std::optional<FileSet::Problem> FileSet::prepare_all(bool overwrite) {
  overwrites_ = overwrite;
  sys::allow_open_files(2 * files_.size());  // each file and its folder
  for (const OutputFile& file : files_) {
    if (signals_.has_one()) return Problem{path::join(file.folder, file.path), kInterrupted};
    if (auto found = prepare(file, overwrite)) return found;
  }
  return std::nullopt;
}

std::optional<FileSet::Problem> FileSet::prepare(const OutputFile& file, bool overwrite) {
  const std::string shown = path::join(file.folder, file.path);
  const std::string folder_or_here = file.folder.empty() ? "." : file.folder;
  const std::string& chosen = file.written_as.empty() ? folder_or_here : file.written_as;
  const FollowedPath followed = follow(chosen);
  if (!followed.link_out.empty()) return Problem{shown, reason_of_link(followed.link_out)};
  const std::string judged =
      file.written_as.empty() ? followed.place : std::string(path::parent(followed.place));
  if (const auto reason = why_no_path(file.path); !reason.empty()) {
    return Problem{shown, std::string(reason)};
  }
  int folder = -1;
  if (auto found = open_folder(file, judged, folder)) return found;
  Written& written = written_.emplace_back(folder, std::string(path::file_name(file.path)));
  written.shown = shown;
  written.old_text = file.replaces;
  if (sys::kIgnoresCase && !names_.emplace(folder, path::to_lower(written.file.name())).second) {
    return Problem{shown, "the name of another new file differs only in case"};
  }
  sys::Status status{};
  if (sys::fstatat(folder, written.file.name().c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
    written.replaces = true;
    if (S_ISLNK(status.st_mode)) return problem(shown, ELOOP);
    if (!S_ISREG(status.st_mode)) {
      return problem(shown, S_ISDIR(status.st_mode) ? EISDIR : ENOTSUP);
    }
    if (!overwrite) return problem(shown, EEXIST);
  }
  FileContent content;
  if (file.read) {
    content = file.read();
    if (content.status != ReadStatus::ok) return Problem{shown, content.reason};
  }
  const int error = written.file.write(file.read ? std::string_view(content.text) : file.text,
                                       written.replaces ? std::optional(status) : std::nullopt);
  return error == 0 ? std::nullopt : std::optional(problem(shown, error));
}

std::optional<FileSet::Problem> FileSet::place(Written& written, bool is_last) {
  const int folder = written.file.folder();
  if (written.old_text && has_changed(folder, written.file.name(), *written.old_text)) {
    return changed(written.shown);
  }
  int error = take_place(written, is_last);
  if (error == EEXIST && overwrites_ && !written.replaces) {  // another run made it meanwhile
    sys::Status status{};
    const char* const name = written.file.name().c_str();
    if (sys::fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode)) {
      written.replaces = true;
      written.file.replace(status);
      error = take_place(written, is_last);
    }
  }
  if (error != 0) return problem(written.shown, error);
  written.is_placed = true;
  return std::nullopt;
}

/// 0 or an errno.
int FileSet::take_place(Written& written, bool is_last) {
  int error = 0;
  if (written.replaces && !is_last) {  // no step after this one can fail
    error = link_backup(written);
    if (error != 0) written.backup.clear();
  }
  return error == 0 ? written.file.take_place() : error;
}

/// 0 or an errno.
int FileSet::link_backup(Written& written) {
  const int folder = written.file.folder();
  const char* const old = written.file.name().c_str();
  int error = ENOENT;
  sys::Status status{};
  // ENOENT, though there is a file: another run has replaced it just now.
  for (int attempt = 0; attempt < 1000 && error == ENOENT; ++attempt) {
    error = with_free_name(written.backup, [&](const std::string& name) {
      return sys::linkat(folder, old, folder, name.c_str(), 0) == 0 ? 0 : errno;
    });
    if (sys::fstatat(folder, old, &status, AT_SYMLINK_NOFOLLOW) != 0) break;
  }
  return error;
}

std::optional<FileSet::Problem> FileSet::open_folder(const OutputFile& file,
                                                     const std::string& judged, int& folder) {
  std::string path = file.folder.empty() ? "." : file.folder;
  if (missing_ == MissingFolders::make) {
    if (const int error = make_all(path); error != 0) return problem(path, error);
  }
  Descriptor& users = folders_[path];
  if (!users.is_open()) {
    users.reset(sys::open(path.c_str(), kFolder));
    if (!users.is_open()) return problem(path, errno);
    if (is_elsewhere(users.number(), judged)) {
      return Problem{path, "another folder has replaced it meanwhile"};
    }
    remove_left_overs(users.number());
  }
  folder = users.number();
  std::string_view rest = path::parent(file.path);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string name(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    path += "/" + name;
    Descriptor& below = folders_[path];
    if (!below.is_open()) {
      int opened = -1;
      const int error = open_below(folder, name, opened);
      if (error != 0) return problem(path, error);
      below.reset(opened);
      remove_left_overs(opened);
    }
    folder = below.number();
  }
  return std::nullopt;
}

/// 0 or an errno; ELOOP for a link.
int FileSet::open_below(int above, const std::string& name, int& folder) {
  if (name.empty() || name == "." || name == "..") return EINVAL;
  if (missing_ == MissingFolders::make && sys::mkdirat(above, name.c_str(), 0777) == 0) {
    made_folders_.emplace_back(above, name);
  }
  folder = sys::openat(above, name.c_str(), kFolder | O_NOFOLLOW);
  if (folder >= 0) return 0;
  const int error = errno;
  return is_link(above, name) ? ELOOP : error;
}

/// 0 or an errno.
int FileSet::make_all(const std::string& folder) {
  sys::Status status{};
  if (folder.empty() || sys::stat(folder.c_str(), &status) == 0) return 0;
  if (const int error = make_all(std::string(path::parent(folder))); error != 0) return error;
  if (sys::mkdir(folder.c_str(), 0777) != 0) {
    return errno == EEXIST ? 0 : errno;  // another run made it meanwhile
  }
  made_folders_.emplace_back(AT_FDCWD, folder);
  return 0;
}

bool write_files(std::string_view tool, const std::vector<OutputFile>& files, bool overwrite,
                 const std::function<bool()>& last_step) {
  FileSet set(files, FileSet::MissingFolders::make);
  const auto found = last_step ? set.write_for_now(overwrite) : set.write(overwrite);
  if (!found) {
    if (last_step && !last_step()) return false;
    set.keep();
    return true;
  }
  const std::string_view remedy = found->exists ? "; see --overwrite" : "";
  complain(tool, "cannot write '" + found->path + "': " + found->reason + std::string(remedy) +
                     "; nothing was written");
  return false;
}

}  // namespace smurf::tools
