// SPDX-License-Identifier: BSD-3-Clause
// A folder whose entries are looked up by short paths, although the path to it may be thousands of
// folders long.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace smurf {

/// Opens a folder only where the path from the last opened one gets long: most need no call at all.
class OpenFolder {
 public:
  explicit OpenFolder(const std::string& path) { open(path); }
  ~OpenFolder() { close(); }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;

  void open(const std::string& path);
  /// Goes to a subfolder that is not a link. A missing subfolder counts as empty.
  void enter(const std::string& name);
  /// Goes to the parent of this folder; `above` is the path of the parent. This folder need not
  /// exist: an editor may name a new folder in a project.
  void enter_above(const std::string& above);

  /// Whether there is an entry of this name, even a link without a target: a checkout must not
  /// learn what is outside of it.
  bool has(std::string_view name) const;
  bool has_any(std::span<const std::string_view> names) const;
  /// The target of a link as it is written; none if this is not a link.
  std::optional<std::string> target_of(const std::string& name) const;

 private:
  void close();
  /// Opens the folder.
  void settle();
  std::string path_of(std::string_view name) const;

  int number_ = -1;   ///< an open folder; negative: none
  std::string rest_;  ///< the path from there, or from the current folder if none is open
  bool is_missing_ = false;
};

}  // namespace smurf
