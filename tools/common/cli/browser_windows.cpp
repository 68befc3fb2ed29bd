// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "base/files/system.hpp"
#include "base/files/windows_paths.hpp"
#include "common/cli/browser.hpp"
// The headers of Windows come last, because they define many macros; the others need the first one.
#include <windows.h>

#include <shellapi.h>

namespace smurf::tools {

std::string temporary_folder() {
  const char* const chosen = std::getenv("TEMP");
  std::string folder = sys::from_user(chosen == nullptr ? "C:\\Windows\\Temp" : chosen);
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

std::string open_for_user(const std::string& target) {
  constexpr std::intptr_t kLastError = 32;  // of ShellExecute
  const std::optional<std::wstring> wide = sys::to_utf16(target);
  if (!wide) return "the path of the page is not Unicode";
  const auto result = reinterpret_cast<std::intptr_t>(
      ::ShellExecuteW(nullptr, L"open", wide->c_str(), nullptr, nullptr, SW_SHOWNORMAL));
  return result > kLastError ? "" : "Windows has no program for pages";
}

}  // namespace smurf::tools
