// SPDX-License-Identifier: BSD-3-Clause
// yaml::Document -> Model and Annotations.
#pragma once

#include <optional>
#include <span>

#include "ast/keys.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// Reads a main file (.smurf). None when the root is not a mapping.
std::optional<Model> read_model(const yaml::Document& document, DiagnosticSink& sink);

/// The keys of a main file that are not sections. Keys of a scene entity are not among them,
/// although MARS lets a main file replace those of the entity that names it.
std::span<const Key<Model>> main_keys();

/// Reads an annotation file (.yml). None when the root is not a mapping.
std::optional<Annotations> read_annotations(const yaml::Document& document, DiagnosticSink& sink);

/// True for a file that keeps templates of parts under the names of sections: mappings from names
/// to mappings. Such files are no annotation files unless a model lists them.
bool holds_templates(const yaml::Document& document);

}  // namespace smurf
