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
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "base/sanitizer.hpp"

namespace smurf::load_check {
namespace {

constexpr int kOutOfMemory = 3;

constexpr bool kHasMemoryLimit = !SMURF_HAS_ADDRESS_SANITIZER;

/// The soft limit ends the process with a signal that identifies the cause; the hard limit applies
/// if the signal is ignored.
void limit(int resource, std::uint64_t most) {
  const rlimit both{most, most + 1};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// Bytes of memory that this process has used so far.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void write_all(int descriptor, const char* bytes, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::write(descriptor, bytes + done, size - done);
    if (count < 0 && errno != EINTR) ::_exit(0);  // nobody reads the pipe any more
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

/// A child sends pieces of the output of a task, each after its size. An empty piece ends the
/// task.
using PieceSize = std::uint64_t;

void write_piece(int descriptor, const std::string& text) {
  const PieceSize size = text.size();
  write_all(descriptor, reinterpret_cast<const char*>(&size), sizeof size);
  write_all(descriptor, text.data(), text.size());
}

/// Tasks begin..end-1, which are in one group.
struct Batch {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t group = 0;
};

[[noreturn]] void run_child(const Batch& batch, int descriptor, const ChildLimits& limits,
                            const ChildTask& task) {
  limit(RLIMIT_CORE, 0);
  const rlimit nothing{0, 0};
  ::setrlimit(RLIMIT_FSIZE, &nothing);  // limits do not apply to the pipe to the parent
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(limits.seconds));
  // A waiting child uses no processor time, so the wall-clock limit is generous for loaded
  // machines.
  constexpr std::int64_t kPatience = 20;
  constexpr std::int64_t kLongest = std::numeric_limits<int>::max();
  ::alarm(static_cast<unsigned>(std::min(kPatience * limits.seconds, kLongest)));
#ifdef __GLIBC__
  // The free heap of the parent would let the child exceed its limit.
  ::malloc_trim(0);
#endif
  if (kHasMemoryLimit) limit(RLIMIT_AS, address_space() + limits.memory_bytes);
  std::set_new_handler([] { ::_exit(kOutOfMemory); });
  try {
    for (std::size_t i = batch.begin; i < batch.end; ++i) {
      task(i, [descriptor](const std::string& text) {
        if (!text.empty()) write_piece(descriptor, text);
      });
      write_piece(descriptor, "");
    }
  } catch (const std::bad_alloc&) {
    ::_exit(kOutOfMemory);
  }
  end_child();
}

struct Child {
  pid_t process = -1;
  int pipe = -1;
  Batch batch;            ///< `begin` is the running task
  std::string output;     ///< of that task
  std::string header;     ///< bytes of the size of the next piece
  PieceSize missing = 0;  ///< remaining bytes of the piece
};

/// Seconds of processor time of an ended process.
double seconds_of(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

class Pool {
 public:
  Pool(std::span<const std::size_t> groups, int jobs, const ChildLimits& limits,
       const ChildTask& task, const OnFinished& on_finished)
      : groups_(groups),
        jobs_(static_cast<std::size_t>(jobs)),
        limits_(limits),
        task_(task),
        on_finished_(on_finished) {}

  void run() {
    while (next_ < groups_.size() || !broken_off_.empty() || !running_.empty()) {
      while (running_.size() < jobs_) {
        const Batch batch = next_batch();
        if (batch.begin == batch.end) break;
        start(batch);
      }
      if (!running_.empty()) read_some();
    }
  }

 private:
  using End = ChildOutcome::End;

  /// Starting a child costs as much as a small task, but frees memory that libraries never free.
  /// There are several batches per job, so all jobs end at about the same time.
  std::size_t batch_size() const {
    return std::clamp<std::size_t>(groups_.size() / (4 * jobs_), 1, 64);
  }

  /// Empty if none remain.
  Batch next_batch() {
    if (!broken_off_.empty()) {
      const Batch batch = broken_off_.back();
      broken_off_.pop_back();
      return batch;
    }
    Batch batch{next_, next_, next_ < groups_.size() ? groups_[next_] : 0};
    while (batch.end < groups_.size() && groups_[batch.end] == batch.group &&
           batch.end - batch.begin < batch_size()) {
      ++batch.end;
    }
    next_ = batch.end;
    return batch;
  }

  void finish_all(const Batch& batch, End end) {
    for (std::size_t i = batch.begin; i < batch.end; ++i) {
      on_finished_(i, {.end = end, .signal = 0, .output = {}});
    }
  }

  void start(const Batch& batch) {
    ChildLimits limits = limits_;
    limits.seconds -= static_cast<int>(std::lround(used_[batch.group]));
    if (limits.seconds <= 0) return finish_all(batch, End::no_time_left);
    int ends[2];
    const bool has_pipe = ::pipe(ends) == 0;
    const pid_t process = has_pipe ? ::fork() : -1;
    if (process == 0) {
      ::close(ends[0]);
      for (const Child& other : running_) ::close(other.pipe);
      run_child(batch, ends[1], limits, task_);
    }
    if (has_pipe) ::close(ends[1]);
    if (process < 0) {
      if (has_pipe) ::close(ends[0]);
      return finish_all(batch, End::not_started);
    }
    running_.push_back({process, ends[0], batch, {}, {}});
  }

  void read_some() {
    std::vector<pollfd> waiting;
    for (const Child& child : running_) waiting.push_back({child.pipe, POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0) return;
    for (std::size_t i = waiting.size(); i-- > 0;) {
      if (waiting[i].revents == 0 || read_from(running_[i])) continue;
      Child child = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      finish(std::move(child));
    }
  }

  /// False at the end of the child's output.
  bool read_from(Child& child) {
    const ssize_t count = ::read(child.pipe, buffer_.data(), buffer_.size());
    if (count > 0) take(std::string_view(buffer_.data(), static_cast<std::size_t>(count)), child);
    return count > 0 || (count < 0 && errno == EINTR);
  }

  void take(std::string_view bytes, Child& child) {
    const auto next = [&](std::size_t most) {
      const std::string_view part = bytes.substr(0, most);
      bytes.remove_prefix(part.size());
      return part;
    };
    while (!bytes.empty()) {
      if (child.missing > 0) {
        const std::string_view part = next(child.missing);
        child.output += part;
        child.missing -= part.size();
        continue;
      }
      child.header += next(sizeof(PieceSize) - child.header.size());
      if (child.header.size() < sizeof(PieceSize)) return;
      std::memcpy(&child.missing, child.header.data(), sizeof(PieceSize));
      child.header.clear();
      if (child.missing > 0) continue;
      on_finished_(child.batch.begin++,
                   {.end = End::finished, .signal = 0, .output = std::exchange(child.output, {})});
    }
  }

  void finish(Child child) {
    ::close(child.pipe);
    int status = 0;
    rusage usage{};
    while (::wait4(child.process, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    Batch& batch = child.batch;
    used_[batch.group] += seconds_of(usage);
    if (batch.begin == batch.end) return;
    ChildOutcome outcome{.end = End::finished, .signal = 0, .output = std::move(child.output)};
    if (WIFEXITED(status)) {
      if (WEXITSTATUS(status) == kOutOfMemory) outcome.end = End::out_of_memory;
    } else {
      outcome.signal = WTERMSIG(status);
      outcome.end = end_of(outcome.signal);
    }
    on_finished_(batch.begin++, std::move(outcome));
    if (batch.begin < batch.end) broken_off_.push_back(batch);
  }

  static End end_of(int signal) {
    switch (signal) {
    case SIGXCPU:
    case SIGALRM: return End::out_of_time;
    case SIGKILL: return End::out_of_memory;  // by the kernel, when memory is exhausted
    default: return End::crashed;
    }
  }

  std::span<const std::size_t> groups_;
  std::size_t jobs_;
  const ChildLimits& limits_;
  const ChildTask& task_;
  const OnFinished& on_finished_;
  std::size_t next_ = 0;                ///< the first task that is not in a batch yet
  std::vector<Batch> broken_off_;       ///< remaining tasks of children that ended early
  std::map<std::size_t, double> used_;  ///< seconds, by group
  std::vector<Child> running_;
  std::vector<char> buffer_ =
      std::vector<char>(65536);  ///< as large as a pipe; stacks can be small
};

}  // namespace

void run_in_children(std::span<const std::size_t> groups, int jobs, const ChildLimits& limits,
                     const ChildTask& task, const OnFinished& on_finished) {
  Pool(groups, jobs, limits, task, on_finished).run();
}

void end_child() { ::_exit(0); }

}  // namespace smurf::load_check
