// SPDX-License-Identifier: BSD-3-Clause
// Work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace smurf {

/// As many as asked for; 0: as many as the machine has.
inline std::size_t count_of_jobs(unsigned jobs) {
  constexpr unsigned kMost = 256;
  return std::clamp(jobs > 0 ? jobs : std::thread::hardware_concurrency(), 1U, kMost);
}

/// Calls `work(worker, index)` for every index below `count`, on at most `jobs` threads; `worker`
/// says which of them, below `jobs`. Nothing is promised about the order.
inline void for_each_parallel(std::size_t count, std::size_t jobs,
                              const std::function<void(std::size_t, std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&](std::size_t worker) {
    for (std::size_t index = next++; index < count; index = next++) work(worker, index);
  };
  // The kernel may put a new thread behind its maker though another processor is idle, for 10 ms.
  // So the maker sleeps until all run, and is woken where there is room.
  std::mutex mutex;
  std::condition_variable started;
  std::size_t running = 0;
  std::vector<std::jthread> threads;
  for (std::size_t worker = 1; worker < std::min(jobs, count); ++worker) {
    threads.emplace_back([&, worker] {
      {
        const std::lock_guard lock(mutex);
        ++running;
        started.notify_one();
      }
      run(worker);
    });
  }
  {
    std::unique_lock lock(mutex);
    started.wait(lock, [&] { return running == threads.size(); });
  }
  run(0);
}

}  // namespace smurf
