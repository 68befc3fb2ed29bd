// SPDX-License-Identifier: BSD-3-Clause
// What an expansion has used: work and memory. Each primitive counts here what it does, so that no
// caller can forget it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/deadline.hpp"
#include "smurf/limits.hpp"

namespace smurf::xacro {

/// The only exception of this room: an expansion has used up what it may. Thrown by Meter alone, in
/// whatever loop, and caught at two borders, Evaluator::evaluate() and Expander::guarded(), which
/// make a failure of it.
struct Exhausted {};

class Meter {
 public:
  enum class Reason : std::uint8_t { none, steps, bytes, depth };

  explicit Meter(const Limits& limits)
      : most_steps_(limits.xacro_steps), most_bytes_(limits.xacro_bytes) {
    set_next();
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  /// Work: a step takes at most some 0.2 us.
  void step(std::uint64_t count = 1) {
    steps_ += count;
    if (steps_ > next_) pass();
  }
  /// Bytes that are copied or compared.
  void copy(std::size_t bytes) { step(bytes / 64); }
  /// Bytes that are searched, decoded or hashed.
  void scan(std::size_t bytes) { step(bytes / 16); }

  /// Memory that is kept until the expansion ends.
  void keep(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ > most_bytes_) stop(Reason::bytes);
  }
  void give_back(std::size_t bytes) {
    most_used_ = std::max(most_used_, bytes_);
    bytes_ -= std::min<std::uint64_t>(bytes, bytes_);
  }

  [[noreturn]] void stop(Reason reason) {
    reason_ = reason;
    throw Exhausted{};
  }
  /// Begins again with these steps, for several expressions with one heap.
  void renew(std::uint64_t steps) {
    most_steps_ = steps_ + steps;
    reason_ = Reason::none;
    set_next();
  }
  Reason reason() const { return reason_; }
  bool is_exhausted() const { return reason_ != Reason::none; }
  std::uint64_t steps() const { return steps_; }
  std::uint64_t bytes() const { return bytes_; }
  /// The most bytes that were used at once.
  std::uint64_t most_used() const { return std::max(most_used_, bytes_); }
  std::uint64_t most_steps() const { return most_steps_; }
  std::uint64_t most_bytes() const { return most_bytes_; }

 private:
  /// Steps between two looks at the clock, so that counting costs one comparison.
  static constexpr std::uint64_t kStepsOfLook = Deadline::kWorkOfLook;

  void set_next() { next_ = std::min(most_steps_, steps_ + kStepsOfLook); }
  void pass() {
    if (steps_ > most_steps_) stop(Reason::steps);
    Deadline::look();
    set_next();
  }

  std::uint64_t most_steps_, most_bytes_;
  std::uint64_t next_ = 0;  ///< after so many steps something is compared
  std::uint64_t steps_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t most_used_ = 0;
  Reason reason_ = Reason::none;
};

/// Memory for as long as a function runs.
class Borrowed {
 public:
  Borrowed(Meter& meter, std::size_t bytes) : meter_(meter), bytes_(bytes) { meter.keep(bytes); }
  ~Borrowed() { meter_.give_back(bytes_); }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

 private:
  Meter& meter_;
  std::size_t bytes_;
};

}  // namespace smurf::xacro
