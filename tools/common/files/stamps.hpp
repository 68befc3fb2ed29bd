// SPDX-License-Identifier: BSD-3-Clause
// Which of many files have changed, for tools that follow them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace smurf::tools {

/// Seconds, nanoseconds and size; none if there is no such file.
using Stamp = std::optional<std::tuple<std::int64_t, std::int64_t, std::int64_t>>;
/// By path.
using Stamps = std::map<std::string, Stamp>;

Stamp stamp_of(const std::string& path);
Stamps stamps_of(const std::set<std::string>& paths);

/// "arm.urdf has changed", or "arm.urdf and 2 more files have changed".
std::string describe_changes(const Stamps& before, const Stamps& after);

/// While it exists, the first Ctrl-C is noted, and the second one ends the process.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool has_come();
};

}  // namespace smurf::tools
