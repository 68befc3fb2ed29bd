// SPDX-License-Identifier: BSD-3-Clause
// Selects the findings that make the result of a conversion wrong. All other findings are about the
// input files.
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

/// The reason why the exported URDF would be wrong because of this finding; none if it would be
/// correct: most faults of a robot are copied to its URDF byte for byte.
std::optional<std::string> loss_in_urdf(const Diagnostic& finding, const LinkedModel& model,
                                        const UrdfExport& wanted);

/// The reason why a model that is imported from a URDF would be wrong because of this finding. All
/// its values but those of materials are needed.
std::optional<std::string> loss_in_model(const Diagnostic& finding);

/// The reason why poses or shapes of a flattened scene would be wrong because of this finding. A
/// wrong mass or motor changes neither, and lights and other settings of the world do not decide
/// where anything is.
std::optional<std::string> loss_in_scene(const Diagnostic& finding, const LinkedScene& scene,
                                         const SourceMap& sources);

/// Whether a scene can be written although a finding has a loss: a value of a robot that cannot be
/// read counts as absent, unless a pose needs it. Not for a number that is not finite.
bool can_be_forced(const Diagnostic& finding);

/// Whether a finding says that a file is not there which an MJCF or SDF needs; all else is read.
bool is_about_missing_part(const Diagnostic& finding);

/// Whether a finding only says that a picture does not have what no picture has.
bool is_about_picture(const Diagnostic& finding);

/// Whether a finding of the linter or of a converter names a package of which no file was found.
bool is_about_lost_package(const Diagnostic& finding);

/// Whether urdfdom is known not to crash on a text with these findings.
bool may_ask_urdfdom(std::span<const Diagnostic> findings);

/// The section of the annotations that a finding is about: "motors" of "/motors/3/joint".
std::string_view section_of(const Diagnostic& finding);

}  // namespace smurf
