// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/progress.hpp"

#include <cstdlib>
#include <string_view>

#include "common/cli/process.hpp"
#include "common/files/output.hpp"

namespace smurf::tools {
namespace {

constexpr std::chrono::seconds kShortRun{1};
constexpr std::chrono::milliseconds kBetweenLines{100};
constexpr std::string_view kEraseLine = "\r\x1b[K";

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool has_watcher() {
  return is_terminal(2) && variable("CI").empty() && variable("TERM") != "dumb";
}

}  // namespace

Progress::Progress(std::string verb, std::size_t count, bool quiet)
    : verb_(std::move(verb)),
      count_(count),
      is_shown_(!quiet && count > 1 && has_watcher()),
      next_(Clock::now() + kShortRun) {}

Progress::~Progress() {
  if (has_line_) write_error(kEraseLine);
}

void Progress::set(std::size_t done) {
  if (!is_shown_) return;
  const std::unique_lock lock(line_, std::try_to_lock);
  if (!lock || Clock::now() < next_) return;
  next_ = Clock::now() + kBetweenLines;
  has_line_ = true;
  write_error(std::string(kEraseLine) + verb_ + " " + std::to_string(done) + " of " +
              std::to_string(count_));
}

}  // namespace smurf::tools
