// SPDX-License-Identifier: BSD-3-Clause
// The parameter files of MoveIt, and questions that several rules ask.
#pragma once

#include <functional>

#include "lint/companions/check.hpp"

namespace smurf {

/// Calls `visit` for every companion of a kind with its root, if that is a mapping.
void for_each_file(const Companions& companions, CompanionKind kind,
                   const std::function<void(const Companion&, yaml::View)>& visit);

/// Calls `visit` for every joint in a joint_limits.yaml: a mapping below its name.
void for_each_joint_limit(const Companions& companions,
                          const std::function<void(const Companion&, yaml::View)>& visit);

}  // namespace smurf
