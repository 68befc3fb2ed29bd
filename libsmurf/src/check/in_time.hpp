// SPDX-License-Identifier: BSD-3-Clause
// Ends the work on a file that takes more processor time than CheckSettings::max_seconds.
#pragma once

#include <cstdint>
#include <string>

#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "smurf/check.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Reports that the work on a file was stopped.
inline Diagnostic& report_out_of_time(const std::string& path, std::uint64_t seconds,
                                      SourceMap& sources, DiagnosticSink& sink) {
  const Span place{sources.add_unreadable(path::normalize(path)), 0, 0};
  return sink
      .report(rules::sml0002_file_too_large, place,
              "this file, with all that it loads, took more than " + std::to_string(seconds) +
                  " s of processor time and was left")
      .note("what else is wrong in it is unknown")
      .help("allow more time with `--max-seconds N`, or leave the file out with `exclude`");
}

/// Of the settings with which it was loaded.
std::uint64_t max_seconds_of(const Loaded& loaded);

/// False, with a call of `stopped`, if the time is over. When it is that of an outer deadline, for
/// example of a request to a server, the outer one ends.
template <class Work, class Stopped>
bool run_in_time(std::uint64_t seconds, const Work& work, const Stopped& stopped) {
  try {
    const Deadline deadline(seconds);
    work();
    return true;
  } catch (const OutOfTime&) {
    Deadline::look();
    stopped();
    return false;
  }
}

}  // namespace smurf
