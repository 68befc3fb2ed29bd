// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/watch.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include "base/files/places.hpp"
#include "base/text/counted.hpp"
#include "common/files/output.hpp"
#include "common/files/stamps.hpp"
#include "smurf/found_inputs.hpp"

namespace smurf::tools {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kShortestWait{200};  ///< between two looks at the files
constexpr int kShare = 20;  ///< of the time, one part of this many is spent on looking

Stamps watched(const std::set<std::string>& seen, const LintOptions& options) {
  Stamps stamps = stamps_of(seen);
  const auto add = [&](const std::string& path) { stamps.try_emplace(path, stamp_of(path)); };
  std::vector<std::string> named = options.paths;
  if (named.empty()) named = {"."};
  for (const std::string& path : named) {
    add(path);
    if (!places::is_folder(path)) continue;
    const FoundInputs found = find_inputs(path, options.limits);
    for (const std::string& file : found.files) add(file);
    for (const std::string& file : found.xacro) add(file);
  }
  return stamps;
}

/// Returns after a change, with the new stamps; none after Ctrl-C.
std::optional<Stamps> wait_for_change(const Stamps& known, const std::set<std::string>& seen,
                                      const LintOptions& options) {
  Clock::duration wait = kShortestWait;
  while (!Interruption::has_come()) {
    const Clock::time_point until = Clock::now() + wait;
    while (!Interruption::has_come() && Clock::now() < until)
      std::this_thread::sleep_for(kShortestWait);
    const Clock::time_point begin = Clock::now();
    Stamps now = watched(seen, options);
    if (now != known) return now;
    wait = std::max<Clock::duration>(kShortestWait, kShare * (Clock::now() - begin));
  }
  return std::nullopt;
}

}  // namespace

ExitCode watch(const LintOptions& options, const WatchedCheck& check) {
  const Interruption interruption;
  std::set<std::string> seen;
  while (!Interruption::has_come()) {
    Stamps known = watched(seen, options);
    std::set<std::string> read;
    check(read);
    // A run that fails early has seen less than the one before it.
    seen.merge(read);
    // The older stamps show changes during the check.
    for (auto& [path, stamp] : watched(seen, options)) known.try_emplace(path, stamp);
    if (Interruption::has_come()) break;
    if (!options.quiet) {
      complain(kSmurfLint,
               "waiting for changes of " + counted(known.size(), "path") + "; Ctrl-C ends it");
    }
    const std::optional<Stamps> now = wait_for_change(known, seen, options);
    if (!now) break;
    complain(kSmurfLint, describe_changes(known, *now));
  }
  return kDone;
}

}  // namespace smurf::tools
