// SPDX-License-Identifier: BSD-3-Clause
// Which files a launch file, or the .setup_assistant of MoveIt, gives to which robot, and with
// which arguments of its xacro.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "link/companions/places.hpp"
#include "smurf/companions.hpp"
#include "smurf/load.hpp"
#include "smurf/surroundings.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf {

/// What one file says belongs together.
struct StatedTie {
  Evidence evidence{};
  std::string by;                   ///< the file that says so
  std::vector<std::string> robots;  ///< by identity
  std::vector<std::string> files;
  struct Argument {
    std::string robot;  ///< by identity
    std::string name, value;
  };
  std::vector<Argument> arguments;  ///< whose values are known
};

/// Each package is read once for all robots of a run. Several threads may use it.
class StatedTies {
 public:
  const std::vector<StatedTie>& in_package(const NearPackage& package, LoadContext& context);

 private:
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<const std::vector<StatedTie>>> packages_;  ///< by folder
};

/// The files that the configuration, a launch file or a .setup_assistant gives to robots; a launch
/// file is given to the robots that it starts.
class GivenFiles {
 public:
  GivenFiles() = default;
  /// Those in these packages.
  GivenFiles(const LinkedModel& robot, const std::vector<NearPackage>& packages,
             LoadContext& context);
  /// Whose a file is; `path` is normal.
  Whose whose(const std::string& path) const;

 private:
  struct Files {
    std::set<std::string> own, others;  ///< by normal path
  };
  Files configured_, stated_;
};

/// The values that these files give to the xacro of a robot, which need not be loaded: the first of
/// each file and argument. Packages around the robot are searched.
std::vector<xacro::SeenArgument> stated_arguments(const std::string& robot, LoadContext& context);

}  // namespace smurf
