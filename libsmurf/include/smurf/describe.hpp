// SPDX-License-Identifier: BSD-3-Clause
// What a named thing is, in a few lines for a person.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/mesh.hpp"
#include "smurf/names.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// The first line says what it is; names are in backticks. Empty when the name is unknown.
std::vector<std::string> describe(const LinkedModel& model, const Reference& reference);
/// The same for a scene, which also has entities.
std::vector<std::string> describe(const LinkedScene& scene, const Reference& reference);

/// The pose of a link when all joints are at zero, and the joints on the way there from the root.
/// With `X_LP`, of the thing that has this pose in the frame of the link.
std::vector<std::string> describe_place(const LinkedModel& model, LinkIndex link,
                                        const std::optional<Pose>& X_LP = std::nullopt);

/// Format, size in metres with this scale, triangles, unit.
std::vector<std::string> describe(const MeshFacts& mesh, const Vector3& scale);

/// "xyz 0 0 0.1  rpy 0 0 90 deg".
std::string describe(const Pose& pose);
/// "86 deg": of an angle in radians.
std::string in_degrees(double radians);

}  // namespace smurf
