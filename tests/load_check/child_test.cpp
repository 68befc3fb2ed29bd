// SPDX-License-Identifier: BSD-3-Clause
// The parent reports the end of a child, however it ends, and goes on.
#include "smurf-load-check/child.hpp"

#include <doctest/doctest.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <climits>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <new>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/sanitizer.hpp"
#include "support/temporary_folder.hpp"

using namespace smurf::load_check;
using End = ChildOutcome::End;
using Write = std::function<void(const std::string&)>;

namespace {

constexpr ChildLimits kLimits{.seconds = 1, .memory_bytes = 256ULL << 20U};

/// The test framework catches signals; the tool does not.
void forget_handlers() {
  for (const int signal : {SIGABRT, SIGSEGV, SIGALRM}) std::signal(signal, SIG_DFL);
}

[[maybe_unused]] void take_all_memory() {
  std::vector<std::vector<char>> all;
  while (true) all.emplace_back(1U << 20U, 'x');
}

std::vector<ChildOutcome> outcomes_of(std::span<const std::size_t> groups, int jobs,
                                      const ChildLimits& limits, const ChildTask& task) {
  std::vector<ChildOutcome> outcomes(groups.size());
  std::size_t finished = 0;
  run_in_children(groups, jobs, limits, task, [&](std::size_t one, ChildOutcome outcome) {
    outcomes[one] = std::move(outcome);
    ++finished;
  });
  CHECK(finished == groups.size());
  return outcomes;
}

/// Each task is a separate group.
std::vector<ChildOutcome> outcomes_of(std::size_t count, int jobs, const ChildLimits& limits,
                                      const ChildTask& task) {
  std::vector<std::size_t> groups(count);
  std::iota(groups.begin(), groups.end(), 0U);
  return outcomes_of(groups, jobs, limits, task);
}

void take_all_time() {
  volatile bool goes_on = true;
  while (goes_on) {
  }
}

}  // namespace

TEST_CASE("the end of a child is an outcome") {
  struct Case {
    std::function<void()> act;
    End end;
  };
  const std::vector<Case> cases = {{[] {}, End::finished},
                                   {[] { std::abort(); }, End::crashed},
                                   {[] { std::raise(SIGSEGV); }, End::crashed},
                                   {take_all_time, End::out_of_time},
                                   {[] { std::raise(SIGALRM); }, End::out_of_time},
                                   {[] { throw std::bad_alloc(); }, End::out_of_memory},
                                   {[] { end_child(); }, End::finished}};
  for (const int jobs : {1, 3}) {
    const std::vector<ChildOutcome> outcomes =
        outcomes_of(cases.size(), jobs, kLimits, [&](std::size_t task, const Write& write) {
          write("task " + std::to_string(task));
          forget_handlers();
          cases[task].act();
        });
    for (std::size_t i = 0; i < cases.size(); ++i) {
      CAPTURE(i);
      CHECK(outcomes[i].end == cases[i].end);
      CHECK(outcomes[i].output == "task " + std::to_string(i));
    }
    CHECK(outcomes[1].signal == SIGABRT);
    CHECK(outcomes[2].signal == SIGSEGV);
  }
}

TEST_CASE("tasks of a group end each on its own") {
  const std::vector<std::size_t> groups(300, 7);
  const auto is_fatal = [](std::size_t task) { return task % 50 == 3; };
  for (const int jobs : {1, 3}) {
    const std::vector<ChildOutcome> outcomes =
        outcomes_of(groups, jobs, kLimits, [&](std::size_t task, const Write& write) {
          write(std::to_string(task));
          forget_handlers();
          if (is_fatal(task)) std::abort();
          write(" is done");
        });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      CAPTURE(i);
      CHECK(outcomes[i].end == (is_fatal(i) ? End::crashed : End::finished));
      CHECK(outcomes[i].output == std::to_string(i) + (is_fatal(i) ? "" : " is done"));
    }
  }
}

TEST_CASE("tasks of a group share the time, and other groups have their own") {
  const std::vector<std::size_t> groups = {0, 0, 0, 1};
  const std::vector<ChildOutcome> outcomes =
      outcomes_of(groups, 1, kLimits, [](std::size_t task, const Write&) {
        forget_handlers();
        if (task == 1) take_all_time();
      });
  CHECK(outcomes[0].end == End::finished);
  CHECK(outcomes[1].end == End::out_of_time);
  CHECK(outcomes[2].end == End::no_time_left);
  CHECK(outcomes[3].end == End::finished);
}

// A sanitizer reserves more memory than any limit, so there is none.
#if !SMURF_HAS_ADDRESS_SANITIZER
TEST_CASE("a child that takes all memory is told from one that crashes") {
  // On a busy machine, the memory takes more than a second.
  constexpr ChildLimits kSlow{.seconds = 60, .memory_bytes = kLimits.memory_bytes};
  const std::vector<ChildOutcome> outcomes =
      outcomes_of(1, 1, kSlow, [](std::size_t, const Write&) { take_all_memory(); });
  CHECK(outcomes[0].end == End::out_of_memory);
}

#ifdef __GLIBC__
TEST_CASE("what the parent keeps in its heap for later is no memory for the child") {
  constexpr int kAhead = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_TOP_PAD, kAhead);
  const std::vector<char> block(16U << 20U, 'x');  // more memory than remains in the heap
  mallopt(M_TOP_PAD, 1 << 20);
  const ChildLimits limits{.seconds = 10, .memory_bytes = 32ULL << 20U};
  const std::vector<ChildOutcome> outcomes =
      outcomes_of(1, 1, limits, [](std::size_t, const Write&) {
        std::vector<std::vector<char>> all;
        while (all.size() < 64) all.emplace_back(1U << 20U, 'x');
      });
  CHECK(outcomes[0].end == End::out_of_memory);
}
#endif
#endif

TEST_CASE("a child writes to no file") {
  const smurf::test::TemporaryFolder folder;
  const std::string path = folder / "written.txt";
  const std::vector<ChildOutcome> outcomes =
      outcomes_of(1, 1, kLimits, [&](std::size_t, const Write& write) {
        write("to the parent");
        std::signal(SIGXFSZ, SIG_DFL);
        std::ofstream(path) << "text" << std::flush;
        write("never");
      });
  CHECK(outcomes[0].end == End::crashed);
  CHECK(outcomes[0].signal == SIGXFSZ);
  CHECK(outcomes[0].output == "to the parent");
  CHECK(std::ifstream(path).peek() == std::ifstream::traits_type::eof());
}

TEST_CASE("a long output arrives whole") {
  const std::string part(100'000, 'x');
  const std::vector<ChildOutcome> outcomes =
      outcomes_of(2, 2, kLimits, [&](std::size_t, const Write& write) {
        for (int i = 0; i < 10; ++i) write(part);
      });
  for (const ChildOutcome& outcome : outcomes) CHECK(outcome.output.size() == 1'000'000);
}
