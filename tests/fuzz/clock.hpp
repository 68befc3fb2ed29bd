// SPDX-License-Identifier: BSD-3-Clause
// A bound on the processor time of an input. libFuzzer measures time by the wall, and limits on
// steps hide what a step costs.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace smurf::test {

/// Ends the program when its scope took too long. Inputs have at most 20 kB, and sanitizers take
/// ten times as long.
class Clock {
 public:
  explicit Clock(double most_seconds = 5) : most_seconds_(most_seconds) {}
  ~Clock() {
    const double seconds = static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    if (seconds <= most_seconds_) return;
    std::fprintf(stderr, "broken promise: an input took %.1f s of processor time\n", seconds);
    std::abort();
  }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

 private:
  double most_seconds_;
  std::clock_t begin_ = std::clock();
};

}  // namespace smurf::test
