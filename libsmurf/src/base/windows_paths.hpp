// SPDX-License-Identifier: BSD-3-Clause
// Paths of base/system.hpp in the form that Windows takes, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace smurf::sys {

/// "\\?\C:\robots": so that no name in it means a device, a stream or a pattern, and may be long.
/// None with an errno when no file can have the name.
std::optional<std::wstring> to_windows(std::string_view path);

/// "/C:/robots" of "\\?\C:\robots" or "C:\robots".
std::string from_windows(std::wstring_view path);

std::string to_utf8(std::wstring_view text);
/// None when it is no UTF-8.
std::optional<std::wstring> to_utf16(std::string_view text);

/// Without ".", ".." and doubled '/', from the root on, with the drive.
std::string with_drive(std::string_view path);

}  // namespace smurf::sys
