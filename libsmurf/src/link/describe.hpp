// SPDX-License-Identifier: BSD-3-Clause
// Describes a named thing in a few lines of text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/mesh.hpp"
#include "smurf/names.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// Describes a named thing: its kind in the first line, names in backticks. Empty if it is unknown.
std::vector<std::string> describe(const LinkedModel& model, const Reference& reference);
/// The same for a scene, which also has entities.
std::vector<std::string> describe(const LinkedScene& scene, const Reference& reference);

/// The pose of a link with all joints at zero, and the joints between the root and the link. With
/// `X_LP`, the pose of a part that has this pose in the frame of the link.
std::vector<std::string> describe_place(const LinkedModel& model, LinkIndex link,
                                        const std::optional<Pose>& X_LP = std::nullopt);

/// Describes a mesh: format, size in metres at this scale, number of triangles, unit.
std::vector<std::string> describe(const MeshFacts& mesh, const Vector3& scale);

/// "xyz 0 0 0.1  rpy 0 0 90 deg".
std::string describe(const Pose& pose);
/// "86 deg" for an angle in radians.
std::string in_degrees(double radians);

}  // namespace smurf
