// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <new>
#include <string_view>

#include "base/files/windows_paths.hpp"
#include "common/cli/command.hpp"
#include "common/cli/process.hpp"
#include "common/files/new_file.hpp"
// The headers of Windows come last, because they define many macros; the others need the first one.
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

namespace smurf::tools {
namespace {

HANDLE handle_of(int descriptor) {
  return ::GetStdHandle(descriptor == 1   ? STD_OUTPUT_HANDLE
                        : descriptor == 2 ? STD_ERROR_HANDLE
                                          : STD_INPUT_HANDLE);
}

[[noreturn]] void end_without_memory() {
  write_all(2, "out of memory\n");
  std::_Exit(kFailed);
}

}  // namespace

/// Writes text as UTF-8 without changing line ends, and lets a terminal show colours.
void prepare_process() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) ::_setmode(descriptor, _O_BINARY);
  ::SetConsoleOutputCP(CP_UTF8);
  for (const int descriptor : {1, 2}) {
    DWORD mode = 0;
    if (::GetConsoleMode(handle_of(descriptor), &mode) == 0) continue;
    ::SetConsoleMode(handle_of(descriptor), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
  ::SetErrorMode(SEM_FAILCRITICALERRORS);  // a drive without a disk does not open a window
  std::set_new_handler(end_without_memory);
}

/// Asks Windows, because the arguments of main() are in an old encoding that lacks characters.
std::vector<std::string> arguments_of(int /*argc*/, const char* const* /*argv*/) {
  int count = 0;
  wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  std::vector<std::string> arguments;
  for (int i = 0; i < count; ++i) arguments.push_back(sys::to_utf8(wide[i]));
  ::LocalFree(wide);
  return arguments;
}

bool is_terminal(int descriptor) {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(descriptor), &mode) != 0;
}

std::optional<std::size_t> terminal_width(int descriptor) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (::GetConsoleScreenBufferInfo(handle_of(descriptor), &info) == 0) return std::nullopt;
  return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

}  // namespace smurf::tools
