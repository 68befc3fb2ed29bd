// SPDX-License-Identifier: BSD-3-Clause
// The robots of xacro in configurations, once for each combination of their arguments.
#pragma once

#include <vector>

#include "check/group.hpp"
#include "check/pipeline.hpp"
#include "smurf/plan.hpp"

namespace smurf {

/// Reports too many combinations in `found`, which is by configuration.
std::vector<PlannedFile> with_variants(const std::vector<PlannedFile>& planned,
                                       const CheckGroups& groups, const CheckContext& context,
                                       std::vector<Judged>& found);

}  // namespace smurf
