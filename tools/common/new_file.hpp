// SPDX-License-Identifier: BSD-3-Clause
// One file that is written out of sight and then takes its place, whole or not at all.
#pragma once

#include <sys/stat.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace smurf::tools {

/// An open file or folder; none when negative.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset(std::exchange(other.number_, -1));
    return *this;
  }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void reset(int number = -1);

 private:
  int number_;
};

/// Writes the whole text; 0 or an errno.
int write_all(int descriptor, std::string_view text);

/// Calls `make` with names for temporary files until it returns something else than EEXIST, and
/// returns that. The last name goes to `name`.
int with_free_name(std::string& name, const std::function<int(const std::string& name)>& make);

/// A file without a name where the system knows such (O_TMPFILE), so that nothing is left of a run
/// that is killed; elsewhere one with a temporary name beside its place.
class NewFile {
 public:
  /// `folder` is open and stays so.
  NewFile(int folder, std::string name) : folder_(folder), name_(std::move(name)) {}
  ~NewFile() { drop(); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// 0 or an errno; a full disk shows here. The file that is to be replaced, if any, hands down its
  /// permissions and, as far as that is allowed, its owner and group; but not the setuid, setgid
  /// and sticky bits, which were given to other bytes.
  int write(std::string_view text, const std::optional<struct stat>& replaced);

  /// 0 or an errno; EEXIST when a file has appeared that was not there before. Other names of a
  /// replaced file (hard links) keep the old content.
  int take_place();

  int folder() const { return folder_; }
  const std::string& name() const { return name_; }

 private:
  int open_nameless();
  int open_named();
  int adopt_owner() const;
  int flush() const;
  int link_to(const std::string& name) const;
  void drop();

  int folder_;
  std::string name_;
  std::string temporary_;  ///< the name it has until it takes its place; "": none
  Descriptor file_;
  std::optional<struct stat> replaced_;
};

}  // namespace smurf::tools
