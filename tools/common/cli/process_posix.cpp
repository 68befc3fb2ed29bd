// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/process.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#ifndef __EMSCRIPTEN__
#include <spawn.h>
#include <sys/wait.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

#include "common/cli/command.hpp"
#include "common/files/output.hpp"

namespace smurf::tools {
namespace {

void prepare_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // Opened in the wrong direction, so that using it is still an error.
    [[maybe_unused]] const int filler = ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
  }
}

/// A run fills its memory once and ends. Small pages would cost a quarter of the time of a large
/// robot, and a tenth of that of a small one. Therefore, all blocks come from one heap, for whose
/// first part the kernel is asked to use large pages. Unused pages need no memory. Does nothing
/// under a limit on the address space.
void prepare_memory() {
#ifdef __GLIBC__
  constexpr std::uintptr_t kPage = std::uintptr_t{2} << 20U;
  constexpr int kAhead = 256 << 20;
  constexpr int kFurther = 1 << 20;
  constexpr int kLargestInHeap = 32 << 20;  // the largest value that mallopt accepts
  constexpr std::size_t kMore = 64;         // larger than what malloc writes around a block
  mallopt(M_MMAP_THRESHOLD, kLargestInHeap);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_TOP_PAD, kAhead);
  // A page that was written before the request stays small. A block, which is kept and never used,
  // goes until shortly before the first large page.
  const auto start = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  const std::uintptr_t begin = (start + kPage / 4 + kPage - 1) & ~(kPage - 1);
  static const void* const volatile block = std::malloc(begin - start - kMore);
  mallopt(M_TOP_PAD, kFurther);
  if (block == nullptr) return;
  const auto end = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  // The result does not matter: large pages are only faster.
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

[[noreturn]] void end_without_memory() {
  constexpr std::string_view kMessage = "out of memory\n";
  [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  ::_exit(kFailed);
}

/// Runs before the constructors of global objects, which may already find no memory.
[[gnu::constructor(101)]] void prepare_for_globals() { std::set_new_handler(end_without_memory); }

}  // namespace

void prepare_process() {
  prepare_streams();
  prepare_memory();
}

std::vector<std::string> arguments_of(int argc, const char* const* argv) {
  return {argv, argv + argc};
}

int run_beside(const std::string& self, const std::string& name,
               const std::vector<std::string>& arguments) {
  const std::size_t slash = self.rfind('/');
  // Without a slash, the shell has found this program on the PATH, and the other one is there, too.
  const std::string program = slash == std::string::npos ? name : self.substr(0, slash + 1) + name;
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(program.c_str(), pointers.data());
  complain("smurf", "cannot run '" + program + "': " + std::strerror(errno));
  return kFailed;
}

std::string find_program(std::string_view name) {
  const char* const variable = std::getenv("PATH");
  std::string_view rest = variable == nullptr ? "/usr/local/bin:/usr/bin:/bin" : variable;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string path = std::string(rest.substr(0, end)) + "/" + std::string(name);
    // A relative folder on the PATH may contain programs that somebody else put there.
    if (path.front() == '/' && end > 0 && ::access(path.c_str(), X_OK) == 0) return path;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

#ifdef __EMSCRIPTEN__
ProgramRun run_program(const std::string& name, const std::vector<std::string>&, std::string_view) {
  return {.problem = "in WebAssembly, no program can be started, and so not " + name};
}
#else
namespace {

/// Both ends of a pipe, which other programs do not inherit.
struct Pipe {
  Pipe() {
#ifdef __linux__
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
#else
    if (::pipe(ends.data()) != 0) ends = {-1, -1};
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
  void close(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }

  std::array<int, 2> ends{-1, -1};
};

pid_t start(std::string program, const std::vector<std::string>& arguments, const Pipe& in,
            const Pipe& out, int& error) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, in.ends[0], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words = arguments;
  std::vector<char*> pointers{program.data()};
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  error = ::posix_spawn(&process, program.c_str(), &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return process;
}

void write_to(Pipe& in, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(in.ends[1], text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;  // it has ended
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  in.close(1);
}

std::string read_from(const Pipe& out) {
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t count = ::read(out.ends[0], buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ProgramRun run_program(const std::string& name, const std::vector<std::string>& arguments,
                       std::string_view input) {
  const std::string program = find_program(name);
  if (program.empty()) return {.problem = "there is no " + name + " on the PATH"};
  Pipe in;
  Pipe out;
  if (in.ends[0] < 0 || out.ends[0] < 0) return {.problem = "there are too many open files"};
  int error = 0;
  const pid_t process = start(program, arguments, in, out, error);
  if (error != 0) return {.problem = "cannot start " + program + ": " + std::strerror(error)};
  in.close(0);
  out.close(1);
  write_to(in, input);
  ProgramRun run;
  run.output = read_from(out);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
  return run;
}
#endif

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

std::optional<std::size_t> terminal_width(int descriptor) {
  winsize size{};
  if (!is_terminal(descriptor) || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0) return std::nullopt;
  return size.ws_col;
}

}  // namespace smurf::tools
