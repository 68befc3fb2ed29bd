// SPDX-License-Identifier: BSD-3-Clause
// The classes that packages export for pluginlib.
#pragma once

#include <vector>

#include "link/companions/places.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// The classes that these packages export, as far as hardware of the robot or a controller in its
/// companions is named like one of them: "arm_driver/Arm" asks for the package arm_driver.
std::vector<ExportedClass> exported_classes(const LinkedModel& model, const Companions& companions,
                                            const std::vector<NearPackage>& packages,
                                            const FileReader& files);

}  // namespace smurf
