// SPDX-License-Identifier: BSD-3-Clause
// Questions about files and folders by path. std::filesystem cannot answer them on Windows, because
// it does not know the paths of base/files/system.hpp.
#pragma once

#include "base/files/path.hpp"
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <system_error>

namespace smurf::places {

/// Also true for a link to a folder.
bool is_folder(const std::string& path);
bool exists(const std::string& path);
/// These three functions do not follow links.
bool is_plain_file(const std::string& path);
bool is_link(const std::string& path);
bool has_entry(const std::string& path);
/// Whether both exist and are the same file.
bool is_same(const std::string& path, const std::string& other);

std::optional<std::string> current_folder(std::error_code& error);
/// The absolute path, not normalised. "" if there is no current folder.
std::string absolute(const std::string& path);
/// The path seen from a folder; "": from the current folder.
inline std::string absolute_from(const std::string& folder, const std::string& path) {
  if (!folder.empty()) return path::join(folder, path);
  return absolute(path.empty() ? "." : path);
}
/// The absolute path without links; none if it does not exist.
std::optional<std::string> canonical(const std::string& path);
/// The same, but parts that do not exist are kept.
std::optional<std::string> weakly_canonical(const std::string& path);
/// weakly_canonical() of the absolute path.
std::optional<std::string> whole(const std::string& path);
/// The path of `path` relative to `folder`, both canonical; "" if there is none.
std::string relative(const std::string& path, const std::string& folder);

enum class Entry : std::uint8_t { file, folder, link, other };

/// Calls `take` with the name and kind of each entry of a folder, until it returns false. The kind
/// is known from listing the folder, which saves a query for each entry.
std::error_code for_each_entry(const std::string& folder,
                               const std::function<bool(std::string name, Entry kind)>& take);

}  // namespace smurf::places
