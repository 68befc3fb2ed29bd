// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/windows_paths.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <vector>

#include "base/files/path.hpp"
#include "base/files/system.hpp"
// The header of Windows comes last, because it defines many macros.
#include <windows.h>

namespace smurf::sys {
namespace {

constexpr std::string_view kNetwork = "/UNC:";  // "\\server\share" is "/UNC:/server/share"
constexpr std::size_t kLongestName = 255;

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_slash(char c) { return c == '/' || c == '\\'; }

/// "C:/robots" or "C:"
bool begins_with_drive(std::string_view path) {
  return path.size() >= 2 && is_letter(path[0]) && path[1] == ':' &&
         (path.size() == 2 || is_slash(path[2]));
}

/// "/C:" for "/C:/robots"; "" if there is no drive.
std::string_view drive_of(std::string_view path) {
  if (path == kNetwork || path.starts_with("/UNC:/")) return path.substr(0, kNetwork.size());
  return path.starts_with('/') && begins_with_drive(path.substr(1)) ? path.substr(0, 3)
                                                                    : std::string_view();
}

/// Whether Windows treats the name as a device in every folder, such as "NUL" and "com1.txt".
bool is_device(std::string_view name) {
  constexpr std::array<std::string_view, 7> kDevices = {"con",    "prn",     "aux",   "nul",
                                                        "conin$", "conout$", "clock$"};
  std::string stem = path::to_lower(name.substr(0, name.find('.')));
  while (stem.ends_with(' ')) stem.pop_back();
  if (std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end()) return true;
  if (!stem.starts_with("com") && !stem.starts_with("lpt")) return false;
  const std::string_view number = std::string_view(stem).substr(3);
  const bool is_digit = number.size() == 1 && number[0] >= '0' && number[0] <= '9';
  return is_digit || number == "\xC2\xB9" || number == "\xC2\xB2" || number == "\xC2\xB3";
}

/// "/C:/robots" for "C:\\robots", and "/UNC:/server/share" for "\\\\server\\share".
std::string with_slashes(std::string_view path) {
  std::string text(path);
  std::replace(text.begin(), text.end(), '\\', '/');
  if (begins_with_drive(text)) return "/" + text;
  if (text.starts_with("//?/")) return with_slashes(text.substr(4));
  if (text.starts_with("//")) return std::string(kNetwork) + text.substr(1);
  return text;
}

/// The last name of a path as it is written on disk.
std::optional<std::string> name_on_disk(const std::string& path) {
  const auto wide = to_windows(path);
  if (!wide || wide->ends_with(L'\\')) return std::nullopt;
  WIN32_FIND_DATAW entry{};
  const HANDLE search =
      ::FindFirstFileExW(wide->c_str(), FindExInfoBasic, &entry, FindExSearchNameMatch, nullptr, 0);
  if (search == INVALID_HANDLE_VALUE) return std::nullopt;
  ::FindClose(search);
  return to_utf8(entry.cFileName);
}

std::string current_folder_here() {
  std::wstring folder(::GetCurrentDirectoryW(0, nullptr), L'\0');
  folder.resize(::GetCurrentDirectoryW(static_cast<DWORD>(folder.size()), folder.data()));
  return from_windows(folder);
}

}  // namespace

std::string to_utf8(std::wstring_view text) {
  if (text.empty()) return {};
  const int length = static_cast<int>(text.size());
  std::string result(text.size() * 3, '\0');
  result.resize(static_cast<std::size_t>(
      ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, result.data(),
                            static_cast<int>(result.size()), nullptr, nullptr)));
  return result;
}

std::optional<std::wstring> to_utf16(std::string_view text) {
  if (text.empty()) return std::wstring();
  std::wstring result(text.size(), L'\0');
  const int length = ::MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text.data(),
                                           static_cast<int>(text.size()), result.data(),
                                           static_cast<int>(result.size()));
  if (length == 0) return std::nullopt;
  result.resize(static_cast<std::size_t>(length));
  return result;
}

std::string with_drive(std::string_view path) {
  std::string whole;
  if (!path.starts_with('/')) {
    whole = current_folder_here() + "/";
  } else if (drive_of(path).empty()) {
    whole = drive_of(current_folder_here());
  }
  whole += path;
  const std::string drive(drive_of(whole));
  std::string below = path::normalize("/" + whole.substr(drive.size()));
  return below == "/" ? drive : drive + below;
}

std::optional<std::wstring> to_windows(std::string_view path) {
  errno = ENOENT;
  if (path.empty()) return std::nullopt;
  const std::string whole = with_drive(path);
  if (whole.size() > path::kLongest) errno = ENAMETOOLONG;
  if (whole.size() > path::kLongest) return std::nullopt;
  const std::string_view drive = drive_of(whole);
  const std::string_view below = std::string_view(whole).substr(drive.size());
  for (std::size_t begin = 1; begin < below.size();) {
    const std::size_t end = std::min(below.find('/', begin), below.size());
    const std::string_view name = below.substr(begin, end - begin);
    if (name.size() > kLongestName) errno = ENAMETOOLONG;
    if (name.size() > kLongestName || !why_no_name(name).empty()) return std::nullopt;
    begin = end + 1;
  }
  auto wide = to_utf16(below);
  if (!wide) return std::nullopt;
  std::replace(wide->begin(), wide->end(), L'/', L'\\');
  if (drive == kNetwork) return L"\\\\?\\UNC" + *wide;
  if (wide->empty()) *wide = L"\\";
  return L"\\\\?\\" + std::wstring{static_cast<wchar_t>(drive[1]), L':'} + *wide;
}

std::string from_windows(std::wstring_view path) {
  constexpr std::wstring_view kPlain = L"\\\\?\\";
  constexpr std::wstring_view kPlainNetwork = L"\\\\?\\UNC\\";
  if (path.starts_with(kPlainNetwork)) {
    return with_slashes("\\\\" + to_utf8(path.substr(kPlainNetwork.size())));
  }
  if (path.starts_with(kPlain)) path.remove_prefix(kPlain.size());
  std::string text = with_slashes(to_utf8(path));
  while (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

std::string_view why_no_name(std::string_view name) {
  const auto is_refused = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 ||
           std::string_view("\\<>:\"|?*").find(c) != std::string_view::npos;
  };
  if (std::any_of(name.begin(), name.end(), is_refused) || name.ends_with('.') ||
      name.ends_with(' ')) {
    return "Windows has no files with such a name";
  }
  return is_device(name) ? "its name is that of a device of Windows" : "";
}

/// Replaces names that differ only in case from those on disk. A path from the root of the current
/// drive gets that drive, so it can be compared with the current folder.
std::string from_user(std::string_view path) {
  std::string text = with_slashes(path);
  if (text.starts_with('/') && drive_of(text).empty()) {
    text.insert(0, drive_of(current_folder_here()));
  }
  for (std::size_t end = 0; end != std::string::npos && text != "-";) {
    const std::size_t begin = end == 0 && !text.starts_with('/') ? 0 : end + 1;
    end = text.find('/', begin);
    const auto name = name_on_disk(text.substr(0, end));
    if (name && name->size() == std::min(end, text.size()) - begin) {
      text.replace(begin, name->size(), *name);
    }
  }
  return text;
}

bool is_named_so(const std::string& path) {
  const std::string text = path::normalize(path);
  const bool is_absolute = path::is_absolute(text);
  std::size_t end = drive_of(text).size();
  while (end < text.size()) {
    const std::size_t begin = end == 0 && !is_absolute ? 0 : end + 1;
    end = text.find('/', begin);
    const std::string asked = text.substr(begin, end == std::string::npos ? end : end - begin);
    if (asked.empty() || asked == "..") continue;
    const auto name = name_on_disk(text.substr(0, end));
    if (name && *name != asked && path::to_lower(*name) == path::to_lower(asked)) return false;
  }
  return true;
}

std::string_view for_others(std::string_view path) {
  const std::string_view drive = drive_of(path);
  return drive.empty() || drive == kNetwork ? path : path.substr(1);
}

std::string_view without_drive(std::string_view path) {
  const std::string_view drive = drive_of(path);
  if (drive.empty()) return path;
  return path.size() == drive.size() ? std::string_view("/") : path.substr(drive.size());
}

}  // namespace smurf::sys
