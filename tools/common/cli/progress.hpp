// SPDX-License-Identifier: BSD-3-Clause
// Progress of a long run, on a terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace smurf::tools {

/// Rewrites one line on standard error, "checked 31 of 400", and erases it at the end. Shows it
/// only on a terminal and after a second; never in CI, and not on terminals that cannot erase
/// (TERM=dumb).
class Progress {
 public:
  /// `verb` is the word for what happens to each of the `count` things: "checked".
  Progress(std::string verb, std::size_t count, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts one more. Several threads may call it.
  void advance() { set(++done_); }
  /// Sets the number that is done.
  void set(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string verb_;
  std::size_t count_;
  bool is_shown_;  ///< on a terminal
  std::atomic<std::size_t> done_ = 0;
  std::mutex line_;
  Clock::time_point next_;  ///< time of the next update; guarded by `line_`
  bool has_line_ = false;   ///< there is a line to erase; guarded by `line_`
};

}  // namespace smurf::tools
