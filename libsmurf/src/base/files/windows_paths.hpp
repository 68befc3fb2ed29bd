// SPDX-License-Identifier: BSD-3-Clause
// Translates between paths of base/files/system.hpp and paths of Windows.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace smurf::sys {

/// "\\?\C:\robots" for "/C:/robots". In this form, paths can be long, and names cannot mean a
/// device, a stream or a pattern. Returns none and sets errno if no file can have the name.
std::optional<std::wstring> to_windows(std::string_view path);

/// "/C:/robots" for "\\?\C:\robots" or "C:\robots".
std::string from_windows(std::wstring_view path);

std::string to_utf8(std::wstring_view text);
/// None if the text is not UTF-8.
std::optional<std::wstring> to_utf16(std::string_view text);

/// The absolute path with its drive, without ".", ".." and doubled '/'.
std::string with_drive(std::string_view path);

}  // namespace smurf::sys
