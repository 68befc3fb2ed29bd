// SPDX-License-Identifier: BSD-3-Clause
// Paths as text with '/': joined and normalised without asking the file system.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::path {

/// No system opens a longer path (PATH_MAX of Linux); such a path is never valid.
inline constexpr std::size_t kLongest = 4096;

/// Folder part without the trailing '/'; "" when there is none, "/" for the root.
std::string_view parent(std::string_view path);
std::string_view file_name(std::string_view path);
/// From the last '.' of the file name: ".smurf"; "" when there is none.
std::string_view extension(std::string_view path);
/// File name without extension.
std::string_view stem(std::string_view path);
bool is_absolute(std::string_view path);
/// The folders and the file of a path: "a", "b" and "c" of "/a//b/c".
std::vector<std::string_view> names(std::string_view path);
/// `path` when absolute, otherwise folder/path, normalised.
std::string join(std::string_view folder, std::string_view path);
/// Resolves "." and ".." and doubled '/' in the text; "" becomes ".". Names longer than kLongest
/// are not changed.
std::string normalize(std::string_view path);
/// A relative path from `folder` to `path` if both are absolute or both are relative; otherwise
/// `path`. Both are normalised first. Returns `path` if `folder` begins with "..".
std::string relative(std::string_view path, std::string_view folder);
std::string to_lower(std::string_view text);

}  // namespace smurf::path
