// SPDX-License-Identifier: BSD-3-Clause
// Whatever a child does, the parent learns how it ended and goes on.
#include "smurf-load-check/child.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdlib>
#include <vector>

using namespace smurf::load_check;
using End = ChildOutcome::End;
using Write = std::function<void(const std::string&)>;

namespace {

constexpr ChildLimits kLimits{.seconds = 1, .memory_bytes = 256ULL << 20U};

/// The test framework catches signals; the tool does not.
void forget_handlers() {
  for (const int signal : {SIGABRT, SIGSEGV, SIGALRM}) std::signal(signal, SIG_DFL);
}

void take_all_memory() {
  std::vector<std::vector<char>> all;
  while (true) all.emplace_back(1U << 20U, 'x');
}

}  // namespace

TEST_CASE("the end of a child is an outcome") {
  const std::vector<std::function<void()>> ends = {
    [] {},
    [] { std::abort(); },
    [] { std::raise(SIGSEGV); },
    [] {
      volatile bool goes_on = true;
      while (goes_on) {
      }
    },
#if !defined(__SANITIZE_ADDRESS__)
    [] { take_all_memory(); },
#endif
    [] { std::raise(SIGALRM); },
    [] { end_child(); }
  };
  const std::vector<End> expected = {
    End::finished,
    End::crashed,
    End::crashed,
    End::out_of_time,
#if !defined(__SANITIZE_ADDRESS__)
    End::out_of_memory,
#endif
    End::out_of_time,
    End::finished
  };
  for (const int jobs : {1, 3}) {
    std::vector<std::size_t> progress;
    const std::vector<ChildOutcome> outcomes = run_in_children(
        ends.size(), jobs, kLimits,
        [&](std::size_t task, const Write& write) {
          write("task " + std::to_string(task));
          forget_handlers();
          ends[task]();
        },
        [&](std::size_t done) { progress.push_back(done); });
    REQUIRE(outcomes.size() == ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      CAPTURE(i);
      CHECK(outcomes[i].end == expected[i]);
      CHECK(outcomes[i].output == "task " + std::to_string(i));
    }
    CHECK(outcomes[1].signal == SIGABRT);
    CHECK(outcomes[2].signal == SIGSEGV);
    CHECK(progress.back() == ends.size());
  }
}

TEST_CASE("a long output arrives whole") {
  const std::string part(100'000, 'x');
  const std::vector<ChildOutcome> outcomes = run_in_children(
      2, 2, kLimits,
      [&](std::size_t, const Write& write) {
        for (int i = 0; i < 10; ++i) write(part);
      },
      [](std::size_t) {});
  for (const ChildOutcome& outcome : outcomes) CHECK(outcome.output.size() == 1'000'000);
}
