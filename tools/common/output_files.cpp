// SPDX-License-Identifier: BSD-3-Clause
// Several files as one step: all are written beside their places first, where a full disk or a
// missing permission shows; only then are they renamed, and what was renamed can be undone.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/path.hpp"
#include "common/output.hpp"

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

struct Problem {
  std::string path;
  int error = 0;
};

class FileSet {
 public:
  FileSet(std::string folder, const std::vector<TextFile>& files)
      : folder_(std::move(folder)), files_(files) {}
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  /// Takes everything back that was not finished.
  ~FileSet() {
    for (const Written& file : written_) {
      if (is_done_) {
        if (!file.backup.empty()) ::unlink(file.backup.c_str());
      } else if (!file.is_renamed) {
        ::unlink(file.temporary.c_str());
        if (!file.backup.empty()) ::unlink(file.backup.c_str());
      } else if (file.backup.empty()) {
        ::unlink(file.path.c_str());
      } else {
        ::rename(file.backup.c_str(), file.path.c_str());
      }
    }
    if (is_done_) return;
    for (auto made = made_folders_.rbegin(); made != made_folders_.rend(); ++made) {
      ::rmdir(made->c_str());
    }
  }

  std::optional<Problem> write(bool overwrite) {
    for (const TextFile& file : files_) {
      if (auto problem = prepare(path::join(folder_, file.path), file.text, overwrite)) {
        return problem;
      }
    }
    for (Written& file : written_) {
      if (::rename(file.temporary.c_str(), file.path.c_str()) != 0) {
        return Problem{file.path, errno};
      }
      file.is_renamed = true;
    }
    is_done_ = true;
    return std::nullopt;
  }

 private:
  struct Written {
    std::string path, temporary;
    std::string backup;  ///< of the file that was there; empty when there was none
    bool is_renamed = false;
  };

  std::optional<Problem> prepare(const std::string& path, std::string_view text, bool overwrite) {
    if (auto problem = make_folder(path::parent(path))) return problem;
    std::error_code error;
    const fs::file_status target = fs::status(path, error);
    const bool exists = fs::exists(fs::symlink_status(path, error));
    if (exists && !fs::is_regular_file(target)) {
      return Problem{path, fs::is_directory(target) ? EISDIR : ENOTSUP};
    }
    if (exists && !overwrite) return Problem{path, EEXIST};
    Written file;
    // Links are followed.
    file.path = exists ? fs::canonical(path, error).string() : path;
    const int descriptor = open_beside(file.path, file.temporary);
    if (descriptor < 0) return Problem{path, errno};
    written_.push_back(file);
    int failed = exists ? keep_old(written_.back(), descriptor) : 0;
    const int unwritten = write_and_close(descriptor, text, true);
    if (failed == 0) failed = unwritten;
    return failed == 0 ? std::nullopt : std::optional(Problem{path, failed});
  }

  /// The old file gets a second name, from which it can be brought back, and hands down its mode.
  static int keep_old(Written& file, int descriptor) {
    struct stat status {};
    if (::stat(file.path.c_str(), &status) != 0) return errno;
    if (::fchmod(descriptor, status.st_mode & 07777U) != 0) return errno;
    const std::string backup = file.temporary + ".old";
    ::unlink(backup.c_str());  // of a run that was killed: the other name is new
    if (::link(file.path.c_str(), backup.c_str()) != 0) return errno;
    file.backup = backup;
    return 0;
  }

  std::optional<Problem> make_folder(std::string_view path) {
    if (path.empty()) return std::nullopt;
    const std::string folder(path);
    std::error_code error;
    if (fs::is_directory(folder, error)) return std::nullopt;
    if (fs::exists(folder, error)) return Problem{folder, ENOTDIR};
    if (auto problem = make_folder(path::parent(path))) return problem;
    if (::mkdir(folder.c_str(), 0777) != 0) return Problem{folder, errno};
    made_folders_.push_back(folder);
    return std::nullopt;
  }

  std::string folder_;
  const std::vector<TextFile>& files_;
  std::vector<Written> written_;
  std::vector<std::string> made_folders_;
  bool is_done_ = false;
};

}  // namespace

bool write_files(std::string_view tool, const std::string& folder,
                 const std::vector<TextFile>& files, bool overwrite) {
  FileSet set(folder, files);
  const std::optional<Problem> problem = set.write(overwrite);
  if (!problem) return true;
  std::string message =
      "cannot write '" + problem->path + "': " + std::generic_category().message(problem->error);
  if (problem->error == EEXIST) message += "; see --overwrite";
  complain(tool, message + "; nothing was written");
  return false;
}

}  // namespace smurf::tools
