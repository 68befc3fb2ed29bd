// SPDX-License-Identifier: BSD-3-Clause
// An open folder: looks up its entries without the path to it, which may be thousands of folders
// long.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace smurf {

class OpenFolder {
 public:
  explicit OpenFolder(const std::string& path) { open(path); }
  ~OpenFolder() { become(-1); }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;

  void open(const std::string& path);
  /// Opens a subfolder that is not a link, or "..", when something in it is asked for. A missing
  /// subfolder counts as empty.
  void enter(const std::string& name);
  /// Opens the parent of this folder; `above` is the path of the parent. This folder need not
  /// exist: an editor may name a new folder in a project.
  void enter_above(const std::string& above);
  bool is_open() const;

  /// Whether there is an entry of this name, even a link without a target: a checkout must not
  /// learn what is outside of it.
  bool has(std::string_view name) const;
  bool has_any(std::span<const std::string_view> names) const;
  /// The target of a link as it is written; none if this is not a link.
  std::optional<std::string> target_of(const std::string& name) const;

 private:
  void become(int number) const;

  mutable int number_ = -1;
  mutable std::string entered_;  ///< the subfolder that is to be opened; empty: none
};

}  // namespace smurf
