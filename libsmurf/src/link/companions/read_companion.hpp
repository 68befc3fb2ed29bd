// SPDX-License-Identifier: BSD-3-Clause
// Reads one file as a companion, whatever its robot is.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "link/companions/kinds.hpp"
#include "smurf/companions.hpp"

namespace smurf {

class CompanionReader {
 public:
  explicit CompanionReader(LoadContext& context) : context_(context) {}

  /// Reads a file as a companion of this kind; none if it cannot be parsed. A xacro file that was
  /// found for a robot may need arguments or packages that are not known here, which is no finding.
  std::optional<Companion> read(const std::string& path, const CompanionSpec& spec,
                                const LinkedModel* robot = nullptr);

 private:
  void read_parameters(const std::string& path, Companion& companion);
  std::optional<SourceId> expanded(SourceId root, const LinkedModel* robot);
  bool is_in_ros2(const std::string& folder);

  LoadContext& context_;
  std::map<std::string, bool> ros2_;  ///< by folder
};

}  // namespace smurf
