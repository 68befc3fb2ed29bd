// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/windows_paths.hpp"
#include "common/cli/command.hpp"
#include "common/cli/process.hpp"
#include "common/files/new_file.hpp"
#include "common/files/output.hpp"
// The headers of Windows come last, because they define many macros; the others need the first one.
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <shellapi.h>

namespace smurf::tools {
namespace {

HANDLE handle_of(int descriptor) {
  return ::GetStdHandle(descriptor == 1   ? STD_OUTPUT_HANDLE
                        : descriptor == 2 ? STD_ERROR_HANDLE
                                          : STD_INPUT_HANDLE);
}

/// A word as the C library of Windows splits a command line: _wspawnv() joins words by blanks.
std::wstring quoted(const std::wstring& word) {
  std::wstring text = L"\"";
  std::size_t slashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') text.append(slashes + 1, L'\\');
    slashes = c == L'\\' ? slashes + 1 : 0;
    text += c;
  }
  return text.append(slashes, L'\\') + L"\"";
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

int run_beside(const std::string& /*self*/, const std::string& name,
               const std::vector<std::string>& arguments) {
  constexpr DWORD kLongest = 32768;
  std::wstring program(kLongest, L'\0');
  program.resize(::GetModuleFileNameW(nullptr, program.data(), kLongest));
  program.resize(program.find_last_of(L'\\') + 1);
  program += sys::to_utf16(name).value_or(L"") + L".exe";
  std::vector<std::wstring> words{quoted(program)};
  for (const std::string& argument : arguments) {
    words.push_back(quoted(sys::to_utf16(argument).value_or(L"")));
  }
  std::vector<const wchar_t*> pointers;
  for (const std::wstring& word : words) pointers.push_back(word.c_str());
  pointers.push_back(nullptr);
  const std::intptr_t code = ::_wspawnv(_P_WAIT, program.c_str(), pointers.data());
  if (code >= 0) return static_cast<int>(code);
  complain("smurf", "cannot run '" + name + ".exe' beside this program");
  return kFailed;
}

ProgramRun run_program(const std::string& name, const std::vector<std::string>& /*arguments*/,
                       std::string_view /*input*/) {
  return {.problem = "on Windows, this program does not start " + name};
}

std::string find_program(std::string_view /*name*/) { return {}; }

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
