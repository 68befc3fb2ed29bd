// SPDX-License-Identifier: BSD-3-Clause
// Runs work in child processes, where a crash or an endless loop is a regular result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace smurf::load_check {

struct ChildLimits {
  int seconds = 10;                            ///< of processor time, for a group of tasks
  std::uint64_t memory_bytes = 160ULL << 20U;  ///< in addition to the memory of the parent
};

struct ChildOutcome {
  enum class End : std::uint8_t {
    finished,
    crashed,
    out_of_time,
    no_time_left,  ///< not started: its group has used the time
    out_of_memory,
    not_started
  };
  End end = End::finished;
  int signal = 0;      ///< End::crashed
  std::string output;  ///< output before the end
};

/// Runs in a child, which cannot write to files; its output is passed to `write`. It may throw
/// std::bad_alloc.
using ChildTask =
    std::function<void(std::size_t task, const std::function<void(const std::string&)>& write)>;

using OnFinished = std::function<void(std::size_t task, ChildOutcome outcome)>;

/// Runs tasks in child processes, at most `jobs` at a time. A child runs tasks of one group, one
/// after the other; a group is a run of equal numbers in `groups`, which has one for each task.
/// If a task fails, the others of its group are still run, as long as time remains.
/// `on_finished` is called in this process after each task. Precondition: this process has one
/// thread.
void run_in_children(std::span<const std::size_t> groups, int jobs, const ChildLimits& limits,
                     const ChildTask& task, const OnFinished& on_finished);

/// Ends this child at once, keeping the output so far.
[[noreturn]] void end_child();

}  // namespace smurf::load_check
