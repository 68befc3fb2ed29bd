// SPDX-License-Identifier: BSD-3-Clause
// yaml::Document -> Model and Annotations.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// Reads a main file (.smurf). None when the root is not a mapping.
std::optional<Model> read_model(const yaml::Document& document, DiagnosticSink& sink);

/// Reads an annotation file (.yml). None when the root is not a mapping.
std::optional<Annotations> read_annotations(const yaml::Document& document, DiagnosticSink& sink);

}  // namespace smurf
