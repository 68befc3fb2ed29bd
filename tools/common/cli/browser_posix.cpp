// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <string>

#include "common/cli/browser.hpp"
#include "common/cli/process.hpp"
#ifndef __EMSCRIPTEN__
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <string_view>
#include <thread>
#endif

namespace smurf::tools {

std::string temporary_folder() {
  const char* const chosen = std::getenv("TMPDIR");
  return chosen != nullptr && *chosen == '/' ? chosen : "/tmp";
}

#ifdef __EMSCRIPTEN__
std::string open_for_user(const std::string&) { return "no program can be started here"; }
#else
namespace {

#ifdef __APPLE__
constexpr std::array<const char*, 1> kOpeners{"open"};
#else
constexpr std::array<const char*, 2> kOpeners{"xdg-open", "wslview"};
#endif

/// Programs that open addresses end soon, or stay as the browser. "" or the reason of a failure.
std::string wait_for_failure(pid_t process, std::string_view name) {
  using namespace std::chrono_literals;
  constexpr auto kLongest = 1500ms;
  constexpr auto kStep = 20ms;
  for (auto waited = 0ms; waited < kLongest; waited += kStep) {
    int status = 0;
    if (::waitpid(process, &status, WNOHANG) != 0) {
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
      return std::string(name) + " found no browser";
    }
    std::this_thread::sleep_for(kStep);
  }
  return {};
}

}  // namespace

std::string open_for_user(const std::string& target) {
  std::string program;
  for (const char* const name : kOpeners) {
    if (program.empty()) program = find_program(name);
  }
  if (program.empty()) {
    return std::string("there is no ") + kOpeners.front() + " here, which starts the browser";
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  // Ctrl-C is not for the browser.
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::string argument = target;
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  pid_t process = 0;
  const int error =
      ::posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return "cannot start " + program + ": " + std::strerror(error);
  return wait_for_failure(process, program);
}
#endif

}  // namespace smurf::tools
