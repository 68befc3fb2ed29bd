// SPDX-License-Identifier: BSD-3-Clause
// Writes one file completely or not at all: to a temporary file first, which then gets the name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/files/descriptor.hpp"
#include "base/files/system.hpp"

namespace smurf::tools {

/// Writes the whole text; 0 or an errno.
int write_all(int descriptor, std::string_view text);

/// The name of a temporary file, which says which process has made it.
std::string temporary_name(int process, std::string_view rest);

/// Calls `make` with names for temporary files until it returns something other than EEXIST, and
/// returns that. Stores the last name in `name`.
int with_free_name(std::string& name, const std::function<int(const std::string& name)>& make);

/// A file without a name where the system supports it (O_TMPFILE), so that a killed run leaves
/// nothing behind; elsewhere a file with a temporary name in the same folder.
class NewFile {
 public:
  /// `folder` must stay open.
  NewFile(int folder, std::string name) : folder_(folder), name_(std::move(name)) {}
  ~NewFile() { drop(); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Returns 0 or an errno, such as that of a full disk. Takes over the permissions of a file that
  /// will be replaced and, as far as allowed, its owner and group; but not the setuid, setgid and
  /// sticky bits, which were given to the old content.
  int write(std::string_view text, const std::optional<sys::Status>& replaced);

  /// After EEXIST: replaces the file that has appeared meanwhile.
  void replace(const sys::Status& appeared) { replaced_ = appeared; }

  /// Returns 0 or an errno; EEXIST when another file has appeared meanwhile. Other names of a
  /// replaced file (hard links) keep the old content.
  int take_place();

  int folder() const { return folder_; }
  const std::string& name() const { return name_; }

 private:
  int open_nameless();
  int open_named();
  int flush() const;
  int link_to(const std::string& name) const;
  void drop();

  int folder_;
  std::string name_;
  std::string temporary_;  ///< until it gets its final name; "": none
  Descriptor file_;
  std::optional<sys::Status> replaced_;
};

}  // namespace smurf::tools
