// SPDX-License-Identifier: BSD-3-Clause
// Which findings make the result of a conversion wrong. The others are just as true of the files it
// is made from.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "smurf/convert.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Why the exported URDF would be wrong with this finding, in words; none when it would not be:
/// most faults of a robot are the same in its URDF, byte for byte.
std::optional<std::string> loss_in_urdf(const Diagnostic& finding, const LinkedModel& model,
                                        const UrdfExport& wanted);

/// Why a model that is imported from a URDF would be wrong with this finding. All its values are
/// needed.
std::optional<std::string> loss_in_model(const Diagnostic& finding);

/// Why poses or shapes of a flattened scene would be wrong with this finding. A wrong mass or motor
/// changes neither.
std::optional<std::string> loss_in_scene(const Diagnostic& finding, const SourceMap& sources);

/// True when urdfdom certainly survives a text with these findings: it crashes on some.
bool may_ask_urdfdom(std::span<const Diagnostic> findings);

/// The section of the annotations that a finding is about: "motors" of "/motors/3/joint".
std::string_view section_of(const Diagnostic& finding);

}  // namespace smurf
