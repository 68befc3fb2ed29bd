// SPDX-License-Identifier: BSD-3-Clause
// Random numbers for property tests. The seed is printed when a test fails; SMURF_TEST_SEED sets
// it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>

namespace smurf::test {

inline std::uint64_t seed() {
  const char* given = std::getenv("SMURF_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 20171206;
}

class Random {
 public:
  explicit Random(std::uint64_t start = seed()) : engine_(start) {}

  std::uint64_t bits() { return engine_(); }
  /// 0 <= result < size
  std::size_t below(std::size_t size) { return static_cast<std::size_t>(engine_() % size); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace smurf::test
