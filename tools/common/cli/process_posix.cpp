// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/process.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

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

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

std::optional<std::size_t> terminal_width(int descriptor) {
  winsize size{};
  if (!is_terminal(descriptor) || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0) return std::nullopt;
  return size.ws_col;
}

}  // namespace smurf::tools
