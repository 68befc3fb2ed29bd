// SPDX-License-Identifier: BSD-3-Clause
// The folders in which the companions of a robot are looked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf {

class PackageSearch;

/// A ROS package around a robot.
struct NearPackage {
  std::string name, folder;
};

/// Where companions may be.
struct CompanionPlaces {
  std::vector<std::string> folders;
  std::size_t own = 0;                ///< the first of them are in the package of the robot
  std::vector<NearPackage> packages;  ///< that of the robot, and those beside it
};

/// The folders of the ROS package around `folder`, and those of packages in the same repository
/// that depend on it or that it depends on. Without a package: the folder, and the folders beside
/// it that robots usually have.
CompanionPlaces companion_places(const std::string& folder, const FileReader& files,
                                 PackageSearch& packages);

/// The `name` of the element `robot`, without parsing the text; "" if there is none.
std::string_view robot_name_in(std::string_view text);

}  // namespace smurf
