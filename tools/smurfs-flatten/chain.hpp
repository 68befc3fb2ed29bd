// SPDX-License-Identifier: BSD-3-Clause
// --explain: the derivation of an instance's pose.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "smurf/dialect.hpp"
#include "smurf/flatten.hpp"

namespace smurf::tools {

/// One line per transform, from the world to the instance, each with its place in the source. None
/// if there are more than kMostSteps. Precondition: the instance has a pose; see explain().
std::optional<std::string> describe_chain(const LinkedScene& scene, const SourceMap& sources,
                                          InstanceIndex instance, const Dialect& dialect);

/// What to name instead of an unknown instance: "; did you mean 'arm'?", or the first instances.
std::string other_instances(const std::string& name, std::span<const std::string_view> known);

}  // namespace smurf::tools
