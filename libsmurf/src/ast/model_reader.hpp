// SPDX-License-Identifier: BSD-3-Clause
// yaml::Document -> Model and Annotations.
#pragma once

#include <optional>
#include <span>

#include "ast/keys.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// Reads a main file (.smurf). None if the root is not a mapping.
std::optional<Model> read_model(const yaml::Document& document, DiagnosticSink& sink);

/// The keys of a main file that are not sections. Keys of a scene entity are not included, although
/// in MARS a main file can override those of the entity.
std::span<const Key<Model>> main_keys();

/// Reads an annotation file (.yml). None if the root is not a mapping.
std::optional<Annotations> read_annotations(const yaml::Document& document, DiagnosticSink& sink);

/// Whether a file contains templates of parts under the names of sections: mappings from names to
/// mappings. Such a file is an annotation file only if a model lists it.
bool holds_templates(const yaml::Document& document);

}  // namespace smurf
