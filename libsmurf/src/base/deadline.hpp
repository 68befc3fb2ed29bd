// SPDX-License-Identifier: BSD-3-Clause
// Processor time behind all limits: what they have not foreseen ends with a finding, and not with a
// machine that is busy for hours.
#pragma once

#include <cstdint>

namespace smurf {

/// Thrown by Deadline::look() and caught where the innermost Deadline was made. No other exception
/// leaves a stage: a deadline that each loop hands on as a result would change every signature for
/// a case that the limits should never let happen.
struct OutOfTime {};

/// The processor time that this thread may use while the object lives. A deadline inside of another
/// one ends with it at the latest. Lives on the stack, because look() finds the innermost one of
/// its thread: most loops have no other way to learn of it.
class Deadline {
 public:
  /// Seconds of processor time; 0: no end.
  explicit Deadline(std::uint64_t seconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Throws OutOfTime if the time is over. `work` is what was done since the last call, in units of
  /// at most 0.2 us: a loop with little work in each turn can look in each. Without it, a clock is
  /// read, which takes about 0.03 us.
  static void look(std::uint64_t work = kWorkOfLook);

  /// After so much work a clock is read.
  static constexpr std::uint64_t kWorkOfLook = 16'384;

  /// How often this thread has asked the system for its processor time, which is a system call of
  /// 0.5 us or more.
  static std::uint64_t count_of_calls();

 private:
  Deadline* outer_;
  double end_ = 0;          ///< s, on the clock of this thread; 0: none
  double earliest_ = 0;     ///< s, on the clock of the machine: before, the time cannot be over
  std::uint64_t work_ = 0;  ///< since a clock was read
};

}  // namespace smurf
