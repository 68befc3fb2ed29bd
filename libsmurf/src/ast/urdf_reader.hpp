// SPDX-License-Identifier: BSD-3-Clause
// xml::Document -> urdf::Robot.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/urdf.hpp"

namespace smurf {

/// Reports SML11xx about structure and SML18xx about numbers; none if the root is not a robot.
std::optional<urdf::Robot> read_urdf(xml::Document document, DiagnosticSink& sink);

/// Whether all of xacro in a document are properties and arguments that nothing uses.
bool has_only_xacro_definitions(const xml::Document& document);

/// The checks by the element table: unknown, misspelt and repeated elements and attributes.
void check_urdf_shape(const xml::Document& document, DiagnosticSink& sink);

}  // namespace smurf
