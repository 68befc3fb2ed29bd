// SPDX-License-Identifier: BSD-3-Clause
// Collects the things of models and scenes.
#pragma once

#include "diff/properties.hpp"
#include "diff/yaml_properties.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// The parts of a model that are compared.
enum class Scope : std::uint8_t { all, robot };

/// Replaces units such as "rad or m" by the unit that applies to the joint, if it has one axis.
void choose_units(Property& property, const urdf::Joint& joint);
/// Appends the things of a URDF.
void collect_robot(const LinkedModel& model, Things& things);
/// Appends the things of the main file and the annotations.
void collect_annotations(const LinkedModel& model, YamlProperties& properties, Things& things);
Things collect(const LinkedModel& model, Scope scope, YamlProperties& properties);

/// Appends the things of the scene files, each file once, however often it is included.
Things collect(const LinkedScene& scene, const SourceMap& sources, YamlProperties& properties);

/// The order of places in files.
inline bool is_before(const Span& a, const Span& b) {
  return a.source != b.source ? a.source < b.source : a.begin < b.begin;
}
/// Sorts by the place of the name, for the lookup of references.
void sort_by_place(std::vector<Reference>& references);

}  // namespace smurf
