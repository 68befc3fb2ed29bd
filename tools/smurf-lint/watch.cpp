// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/watch.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <optional>
#include <thread>
#include <tuple>

#include "base/counted.hpp"
#include "base/places.hpp"
#include "base/system.hpp"
#include "common/discover.hpp"
#include "common/output.hpp"

namespace smurf::tools {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kShortestWait{200};  ///< between two looks at the files
constexpr int kShare = 20;  ///< of the time, one part of this many is spent on looking

volatile std::sig_atomic_t is_stopped = 0;

extern "C" void stop_watching(int) {
  is_stopped = 1;
  std::signal(SIGINT, SIG_DFL);  // the second one ends a long check
}

/// Seconds, nanoseconds and size; none if there is no such file.
using Stamp = std::optional<std::tuple<std::int64_t, std::int64_t, std::int64_t>>;
using Stamps = std::map<std::string, Stamp>;

Stamp stamp_of(const std::string& path) {
  sys::Status status{};
  if (sys::stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::tuple(static_cast<std::int64_t>(status.st_mtim.tv_sec),
                    static_cast<std::int64_t>(status.st_mtim.tv_nsec),
                    static_cast<std::int64_t>(status.st_size));
}

Stamps stamps_of(const std::set<std::string>& seen, const LintOptions& options) {
  Stamps stamps;
  const auto add = [&](const std::string& path) { stamps.try_emplace(path, stamp_of(path)); };
  for (const std::string& path : seen) add(path);
  std::vector<std::string> named = options.paths;
  if (named.empty()) named = {"."};
  for (const std::string& path : named) {
    add(path);
    if (!places::is_folder(path)) continue;
    const Found found = find_inputs(path, options.limits);
    for (const std::string& file : found.files) add(file);
    for (const std::string& file : found.xacro) add(file);
  }
  return stamps;
}

/// "arm.urdf", or "arm.urdf and 2 more files".
std::string changed(const Stamps& before, const Stamps& after) {
  std::vector<std::string> names;
  for (const auto& [path, stamp] : after) {
    const auto old = before.find(path);
    if ((old == before.end() || old->second != stamp) && !places::is_folder(path)) {
      names.push_back(path);
    }
  }
  for (const auto& [path, stamp] : before) {
    if (!after.contains(path)) names.push_back(path);
  }
  if (names.empty()) return "a folder has";
  if (names.size() == 1) return names.front() + " has";
  return names.front() + " and " + counted(names.size() - 1, "more file") + " have";
}

/// Returns after a change, with the new stamps; none after Ctrl-C.
std::optional<Stamps> wait_for_change(const Stamps& known, const std::set<std::string>& seen,
                                      const LintOptions& options) {
  Clock::duration wait = kShortestWait;
  while (is_stopped == 0) {
    const Clock::time_point until = Clock::now() + wait;
    while (is_stopped == 0 && Clock::now() < until) std::this_thread::sleep_for(kShortestWait);
    const Clock::time_point begin = Clock::now();
    Stamps now = stamps_of(seen, options);
    if (now != known) return now;
    wait = std::max<Clock::duration>(kShortestWait, kShare * (Clock::now() - begin));
  }
  return std::nullopt;
}

}  // namespace

FileContent SeenFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  add(path);
  return behind_.read(path, max_bytes);
}

bool SeenFiles::is_file(const std::string& path) const {
  add(path);
  return behind_.is_file(path);
}

void SeenFiles::add(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  paths_.insert(path);
}

ExitCode watch(const LintOptions& options, const WatchedCheck& check) {
  std::signal(SIGINT, stop_watching);
  std::set<std::string> seen;
  while (is_stopped == 0) {
    Stamps known = stamps_of(seen, options);
    std::set<std::string> read;
    check(read);
    // A run that fails early has seen less than the one before it.
    seen.merge(read);
    // The older stamps show changes during the check.
    for (auto& [path, stamp] : stamps_of(seen, options)) known.try_emplace(path, stamp);
    if (is_stopped != 0) break;
    if (!options.quiet) {
      complain(kSmurfLint,
               "waiting for changes of " + counted(known.size(), "path") + "; Ctrl-C ends it");
    }
    const std::optional<Stamps> now = wait_for_change(known, seen, options);
    if (!now) break;
    complain(kSmurfLint, changed(known, *now) + " changed");
  }
  std::signal(SIGINT, SIG_DFL);
  return kDone;
}

}  // namespace smurf::tools
