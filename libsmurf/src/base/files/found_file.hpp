// SPDX-License-Identifier: BSD-3-Clause
// A file that was found, but not opened yet.
#pragma once

#include <optional>
#include <string>

#include "base/files/descriptor.hpp"
#include "base/files/system.hpp"

namespace smurf {

/// The file at a path. Devices and pipes are not opened. A file that is opened later is the file
/// that was found, even if the path has changed.
class FoundFile {
 public:
  explicit FoundFile(const std::string& path);

  /// 0, or the errno of the failure.
  int error() const { return error_; }
  const sys::Status& status() const { return status_; }
  /// Its real path, with all links followed; none if it has no path. Of a missing file, only if no
  /// name on the way to it is a link.
  std::optional<std::string> real_path() const;
  /// A descriptor to read a regular file or a folder, or -1 with errno.
  int open() const;

 private:
  std::string path_;
  mutable std::optional<std::string> looked_up_;  ///< for systems without paths of open files
  struct Opened {
    int number = -1;
    bool is_unlinked = false;
  };
  FoundFile(const std::string& path, Opened opened);
  static Opened open_place(const std::string& path);

  bool is_unlinked_;  ///< no name on the way is a link
  Descriptor place_;
  sys::Status status_{};
  int error_ = 0;
};

}  // namespace smurf
