// SPDX-License-Identifier: BSD-3-Clause
// Both versions over each other, as the page of differences shows them.
#pragma once

#include <string>

#include "smurf-diff/versions.hpp"

namespace smurf::tools {

/// The page of write_both_versions(); "" for annotation files, if the poses of a version are
/// unknown, and if this build has no viewer.
std::string picture_of(Session& session, const InputVersion& before, const InputVersion& after,
                       const Options& options);

}  // namespace smurf::tools
