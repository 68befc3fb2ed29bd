// SPDX-License-Identifier: BSD-3-Clause
// Source -> yaml::Document. The only place that knows yaml-cpp.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Reports SML00xx and returns the tree of the first document; none when the text is not YAML.
/// An empty file gives a document without a root.
std::optional<yaml::Document> parse_yaml(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink);

/// yaml-cpp decides what YAML is. The scanner of plain_yaml.hpp reads the same of what it knows,
/// only faster; parse_yaml() asks it first.
enum class YamlEngine : bool { scanner_first, yaml_cpp };
std::optional<yaml::Document> parse_yaml_by(YamlEngine engine, const SourceMap& sources,
                                            SourceId id, const Limits& limits,
                                            DiagnosticSink& sink);

}  // namespace smurf
