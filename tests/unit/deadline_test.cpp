// SPDX-License-Identifier: BSD-3-Clause
#include "base/deadline.hpp"

#include <doctest/doctest.h>

#include <thread>

#include "base/files/system.hpp"

using namespace smurf;

namespace {

/// Works until the clock says stop, at most for so many seconds. True if it was stopped.
bool is_stopped_within(double seconds) {
  const double end = sys::thread_seconds() + seconds;
  try {
    while (sys::thread_seconds() < end) Deadline::look(1000);
  } catch (const OutOfTime&) {
    return true;
  }
  return false;
}

}  // namespace

TEST_CASE("work ends with its deadline, and without one not at all") {
  CHECK_FALSE(is_stopped_within(0.01));
  const Deadline none(0);
  CHECK_FALSE(is_stopped_within(0.01));
  const Deadline deadline(1);
  CHECK(is_stopped_within(5));
}

TEST_CASE("a deadline inside of another one ends with it, and other threads have their own") {
  const Deadline outer(1);
  {
    const Deadline inner(100);
    CHECK(is_stopped_within(5));
  }
  {
    const Deadline inner(0);
    CHECK(is_stopped_within(5));
  }
  bool is_stopped = true;
  std::thread([&] { is_stopped = is_stopped_within(0.01); }).join();
  CHECK_FALSE(is_stopped);
  CHECK(is_stopped_within(5));
}

TEST_CASE("the system is asked only when the time may be over") {
  const Deadline deadline(100);
  const std::uint64_t before = Deadline::count_of_calls();
  for (int i = 0; i < 10'000; ++i) Deadline::look();
  CHECK(Deadline::count_of_calls() == before);
}
