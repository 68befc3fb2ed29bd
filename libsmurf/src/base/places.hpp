// SPDX-License-Identifier: BSD-3-Clause
// What the system tells about places by their paths. On Windows, std::filesystem does not know the
// form of paths of base/system.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <system_error>

namespace smurf::places {

/// True also for a link to a folder.
bool is_folder(const std::string& path);
bool exists(const std::string& path);
/// Links are not followed by these three.
bool is_plain_file(const std::string& path);
bool is_link(const std::string& path);
bool has_entry(const std::string& path);
/// Are both there and one file?
bool is_same(const std::string& path, const std::string& other);

std::optional<std::string> current_folder(std::error_code& error);
/// From the root on; not normalised. "" when there is no current folder.
std::string absolute(const std::string& path);
/// With its links followed; none when nothing is there.
std::optional<std::string> canonical(const std::string& path);
/// The same, but what does not exist keeps its name.
std::optional<std::string> weakly_canonical(const std::string& path);
/// That of the absolute path.
std::optional<std::string> whole(const std::string& path);
/// `path` as seen from `folder`, both canonical; "" when there is no way.
std::string relative(const std::string& path, const std::string& folder);

enum class Entry : std::uint8_t { file, folder, link, other };

/// Calls `take` with the name and kind of all that is in a folder, until it returns false. The kind
/// is as the folder lists it, which saves a query of the file system for each entry.
std::error_code for_each_entry(const std::string& folder,
                               const std::function<bool(std::string name, Entry kind)>& take);

}  // namespace smurf::places
