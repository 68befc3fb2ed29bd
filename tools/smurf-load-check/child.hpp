// SPDX-License-Identifier: BSD-3-Clause
// Work in child processes: a crash or an endless loop there is an outcome here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace smurf::load_check {

struct ChildLimits {
  int seconds = 10;                            ///< of processor time, for a group of tasks
  std::uint64_t memory_bytes = 160ULL << 20U;  ///< above what the parent has
};

struct ChildOutcome {
  enum class End : std::uint8_t {
    finished,
    crashed,
    out_of_time,
    no_time_left,  ///< never begun: its group has used the time
    out_of_memory,
    not_started
  };
  End end = End::finished;
  int signal = 0;      ///< End::crashed
  std::string output;  ///< what was written before the end
};

/// Runs in a child, which can write to no file; what it passes to `write` is the output. It may
/// throw std::bad_alloc.
using ChildTask =
    std::function<void(std::size_t task, const std::function<void(const std::string&)>& write)>;

using OnFinished = std::function<void(std::size_t task, ChildOutcome outcome)>;

/// Runs tasks in child processes, at most `jobs` at a time. A child runs tasks of one group only,
/// one after the other; a group is a run of equal numbers in `groups`, which has one for each task.
/// Others of the group are run whatever becomes of one, as long as they have time left.
/// `on_finished` is called in this process when a task is done. Precondition: this process has one
/// thread.
void run_in_children(std::span<const std::size_t> groups, int jobs, const ChildLimits& limits,
                     const ChildTask& task, const OnFinished& on_finished);

/// Ends this child at once, with what was written so far.
[[noreturn]] void end_child();

}  // namespace smurf::load_check
