// SPDX-License-Identifier: BSD-3-Clause
// Progress of a long run, on a terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace smurf::tools {

/// One line on standard error that is written over and over, "checked 31 of 400", and erased at the
/// end. It appears when standard error is a terminal and the run takes longer than a second; never
/// under CI and on terminals that cannot erase (TERM=dumb).
class Progress {
 public:
  /// `verb` says what is done to each of the `count` things: "checked".
  Progress(std::string verb, std::size_t count, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done. May be called by several threads.
  void advance() { set(++done_); }
  /// So many are done.
  void set(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string verb_;
  std::size_t count_;
  bool is_shown_;  ///< somebody would see it
  std::atomic<std::size_t> done_ = 0;
  std::mutex line_;
  Clock::time_point next_;  ///< when it is written next; guarded by `line_`
  bool has_line_ = false;   ///< something is to be erased; guarded by `line_`
};

}  // namespace smurf::tools
