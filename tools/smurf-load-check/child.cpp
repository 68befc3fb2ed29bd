// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/child.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "base/sanitizer.hpp"

namespace smurf::load_check {
namespace {

constexpr int kOutOfMemory = 3;

constexpr bool kHasMemoryLimit = !SMURF_HAS_ADDRESS_SANITIZER;

/// The soft limit tells what happened, by its own signal; the hard one is for who ignores it.
void limit(int resource, std::uint64_t most) {
  const rlimit both{most, most + 1};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// Bytes that this process has taken so far.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void write_all(int descriptor, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) ::_exit(0);  // nobody listens any more
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

[[noreturn]] void run_child(std::size_t index, int descriptor, const ChildLimits& limits,
                            const ChildTask& task) {
  limit(RLIMIT_CORE, 0);
  const rlimit nothing{0, 0};
  ::setrlimit(RLIMIT_FSIZE, &nothing);  // the pipe to the parent is no file
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(limits.seconds));
  // A waiting child uses no processor time, so the wall-clock limit is generous for loaded
  // machines.
  constexpr std::int64_t kPatience = 20;
  constexpr std::int64_t kLongest = std::numeric_limits<int>::max();
  ::alarm(static_cast<unsigned>(std::min(kPatience * limits.seconds, kLongest)));
#ifdef __GLIBC__
  // What the parent keeps in its heap for later would be the child's beside the limit.
  ::malloc_trim(0);
#endif
  if (kHasMemoryLimit) limit(RLIMIT_AS, address_space() + limits.memory_bytes);
  std::set_new_handler([] { ::_exit(kOutOfMemory); });
  try {
    task(index, [descriptor](const std::string& text) { write_all(descriptor, text); });
  } catch (const std::bad_alloc&) {
    ::_exit(kOutOfMemory);
  }
  end_child();
}

struct Child {
  pid_t process = -1;
  int pipe = -1;
  std::size_t task = 0;
  ChildOutcome outcome = {};
};

class Pool {
 public:
  Pool(const ChildLimits& limits, const ChildTask& task, const OnFinished& on_finished)
      : limits_(limits), task_(task), on_finished_(on_finished) {}

  void run(std::size_t count, int jobs) {
    std::size_t next = 0;
    while (next < count || !running_.empty()) {
      while (next < count && running_.size() < static_cast<std::size_t>(jobs)) start(next++);
      if (!running_.empty()) read_some();
    }
  }

 private:
  void start(std::size_t task) {
    int ends[2];
    const bool has_pipe = ::pipe(ends) == 0;
    const pid_t process = has_pipe ? ::fork() : -1;
    if (process == 0) {
      ::close(ends[0]);
      for (const Child& other : running_) ::close(other.pipe);
      run_child(task, ends[1], limits_, task_);
    }
    if (has_pipe) ::close(ends[1]);
    if (process < 0) {
      if (has_pipe) ::close(ends[0]);
      ChildOutcome outcome;
      outcome.end = ChildOutcome::End::not_started;
      return on_finished_(task, std::move(outcome));
    }
    running_.push_back({process, ends[0], task});
  }

  void read_some() {
    std::vector<pollfd> waiting;
    for (const Child& child : running_) waiting.push_back({child.pipe, POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0) return;
    for (std::size_t i = waiting.size(); i-- > 0;) {
      if (waiting[i].revents == 0 || read_from(running_[i])) continue;
      Child child = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      finish(child);
      on_finished_(child.task, std::move(child.outcome));
    }
  }

  /// False at the end of the child's output.
  static bool read_from(Child& child) {
    char buffer[65536];
    const ssize_t count = ::read(child.pipe, buffer, sizeof buffer);
    if (count > 0) child.outcome.output.append(buffer, static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
  }

  static void finish(Child& child) {
    ::close(child.pipe);
    int status = 0;
    while (::waitpid(child.process, &status, 0) < 0 && errno == EINTR) {
    }
    ChildOutcome& outcome = child.outcome;
    if (WIFEXITED(status)) {
      if (WEXITSTATUS(status) == kOutOfMemory) outcome.end = ChildOutcome::End::out_of_memory;
      return;
    }
    outcome.signal = WTERMSIG(status);
    outcome.end = end_of(outcome.signal);
  }

  static ChildOutcome::End end_of(int signal) {
    switch (signal) {
    case SIGXCPU:
    case SIGALRM: return ChildOutcome::End::out_of_time;
    case SIGKILL: return ChildOutcome::End::out_of_memory;  // by the kernel, when all is taken
    default: return ChildOutcome::End::crashed;
    }
  }

  const ChildLimits& limits_;
  const ChildTask& task_;
  const OnFinished& on_finished_;
  std::vector<Child> running_;
};

}  // namespace

void run_in_children(std::size_t count, int jobs, const ChildLimits& limits, const ChildTask& task,
                     const OnFinished& on_finished) {
  Pool(limits, task, on_finished).run(count, jobs);
}

void end_child() { ::_exit(0); }

}  // namespace smurf::load_check
