// SPDX-License-Identifier: BSD-3-Clause
// Runs work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace smurf {

/// The number of threads: as requested, or for 0 the number of processors.
inline std::size_t count_of_jobs(unsigned jobs) {
  constexpr unsigned kMost = 256;
  return std::clamp(jobs > 0 ? jobs : std::thread::hardware_concurrency(), 1U, kMost);
}

/// Joins its threads in the destructor. libc++ before 20 has no std::jthread.
class Threads {
 public:
  Threads() = default;
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads() {
    for (std::thread& thread : threads_) thread.join();
  }

  /// False if the system cannot start another thread.
  bool start(const std::function<void()>& work) {
    try {
      threads_.emplace_back(work);
    } catch (const std::system_error&) {
      return false;
    }
    return true;
  }

  std::size_t size() const { return threads_.size(); }

 private:
  std::vector<std::thread> threads_;
};

/// Calls `work(worker, index)` for every index below `count`, on at most `jobs` threads; `worker`
/// is the number of the thread, below `jobs`. The order is not defined.
inline void for_each_parallel(std::size_t count, std::size_t jobs,
                              const std::function<void(std::size_t, std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&](std::size_t worker) {
    for (std::size_t index = next++; index < count; index = next++) work(worker, index);
  };
  // The kernel may queue a new thread for 10 ms behind its creator although another processor is
  // idle. So the creator sleeps until all threads run, and wakes up on a free processor.
  std::mutex mutex;
  std::condition_variable started;
  std::size_t running = 0;
  Threads threads;
  for (std::size_t worker = 1; worker < std::min(jobs, count); ++worker) {
    const bool is_started = threads.start([&, worker] {
      {
        const std::lock_guard lock(mutex);
        ++running;
        started.notify_one();
      }
      run(worker);
    });
    if (!is_started) break;  // the other threads do the work
  }
  {
    std::unique_lock lock(mutex);
    started.wait(lock, [&] { return running == threads.size(); });
  }
  run(0);
}

/// Calls `work(worker, index)` as for_each_parallel() does and then, in the order of the indices
/// and one at a time, `take(index)`. After `take` has returned false, it is not called again, so
/// the taken results do not depend on the number of threads.
inline void for_each_in_order(std::size_t count, std::size_t jobs,
                              const std::function<void(std::size_t, std::size_t)>& work,
                              const std::function<bool(std::size_t)>& take) {
  constexpr std::size_t kMostAhead = 64;  // each result that waits for `take` uses memory
  std::mutex mutex;
  std::condition_variable has_room;
  std::vector<bool> is_done(count);
  std::size_t next = 0;
  bool is_over = false;
  const auto start = [&](std::size_t index) {
    std::unique_lock lock(mutex);
    has_room.wait(lock, [&] { return is_over || index < next + kMostAhead; });
    return !is_over;
  };
  const auto end = [&](std::size_t index) {
    const std::lock_guard lock(mutex);
    is_done[index] = true;
    while (!is_over && next < count && is_done[next]) is_over = !take(next++);
    has_room.notify_all();
  };
  for_each_parallel(count, jobs, [&](std::size_t worker, std::size_t index) {
    if (!start(index)) return;
    try {
      work(worker, index);
      end(index);
    } catch (...) {
      // Wake the threads that wait for this file, which will never be finished.
      const std::lock_guard lock(mutex);
      is_over = true;
      has_room.notify_all();
      throw;
    }
  });
}

}  // namespace smurf
